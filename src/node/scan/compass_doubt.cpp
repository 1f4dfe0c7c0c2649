#include "node/scan/compass_doubt.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace place_memory::node {
namespace {

constexpr std::chrono::nanoseconds kLately = std::chrono::seconds(10);
constexpr std::chrono::nanoseconds kPause = std::chrono::milliseconds(100);

std::string inWords(const core::CompassWatch::Finding& found,
                    const config::Parameters& parameters) {
  using Fault = core::CompassWatch::Fault;
  const std::string compass = "the compass (" + parameters.heading_topic + ")";
  const std::string odometry =
      "odometry (" + parameters.odom_frame + " to " + parameters.base_frame + ")";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  if (found.fault == Fault::kOdometryStands) {
    text << odometry << " stands still while " << compass << " turns by " << found.compass
         << " rad: does the base publish it, and count its wheels?";
    return text.str();
  }
  const bool stands = found.fault == Fault::kCompassStands;
  text << compass << (stands ? " stands still" : " turns the other way") << " while " << odometry
       << " turns by " << found.odometry << " rad: ";
  text
      << (stands
              ? "see to its driver, that its heading is fused from a compass or a gyro, and that a "
                "Float64 has it in degrees"
              : "REP 103 counts yaw counter-clockwise; swap the sign of the one that does not, "
                "by parameter heading/reversed where it is the compass");
  return text.str();
}

}  // namespace

void CompassDoubt::observe() {
  if (!locator_.usesOdometry()) return;
  const auto newest = headings_.newest();
  const auto base = locator_.newestBase();
  if (!newest || !base) return;
  const std::chrono::nanoseconds stamp = std::min(newest->stamp, base->stamp);
  const auto watched = watch_.newest();
  if (watched && stamp >= *watched && stamp - *watched < kPause) return;
  const auto heading = headings_.at(stamp);
  std::string problem;
  const auto pose = locator_.baseAt(stamp, problem);
  if (!heading || !pose) return;
  watch_.add(stamp, *heading, pose->yaw);
  const std::string found = find(stamp - kLately);
  // A robot at rest, as after a scan, proves nothing.
  if (!found.empty() || (!now_.empty() && watch_.agree(stamp - kLately))) now_ = found;
  const std::string scan = find(scan_start_);
  if (!scan.empty()) of_scan_ = scan;
}

void CompassDoubt::beginScan(std::chrono::nanoseconds start) {
  scan_start_ = start;
  of_scan_.clear();
}

std::string CompassDoubt::find(std::chrono::nanoseconds from) const {
  const auto found = watch_.find(from);
  return found ? inWords(*found, parameters_) : std::string();
}

}  // namespace place_memory::node
