#include "node/scan/sensor_examiner.h"

#include <tf2/LinearMath/Matrix3x3.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iomanip>
#include <sstream>

namespace place_memory::node {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMostWaiting = 4;
constexpr double kDegrees = 180.0 / core::kPi;

const SensorHealth* find(const std::vector<SensorHealth>& sensors, core::SensorId id) {
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const SensorHealth& sensor) { return sensor.id == id; });
  return found == sensors.end() ? nullptr : &*found;
}

}  // namespace

std::string inWords(const core::SensorDiagnosis& diagnosis, const std::string& sensor,
                    const std::string& other) {
  std::ostringstream text;
  text << std::fixed;
  switch (diagnosis.fault) {
    case core::SensorFault::kNone:
      break;
    case core::SensorFault::kDead:
      text << sensor
           << " is dead: it was heard before, and not in the newest scans; see to its plug";
      break;
    case core::SensorFault::kNeverHears:
      text << sensor << " never hears an echo, though there are walls before it: see to its wiring";
      break;
    case core::SensorFault::kBlocked:
      text << sensor << " is blocked: it hears an echo at " << std::setprecision(2)
           << diagnosis.range << " m wherever it looks; clear what is before it, or turn it";
      break;
    case core::SensorFault::kCrosstalk:
      text << sensor << " hears " << other << ": let them not fire together, or turn one away";
      break;
    case core::SensorFault::kMountedOff:
      text << sensor << " looks " << std::setprecision(0)
           << std::abs(diagnosis.yaw_error) * kDegrees << " +- " << diagnosis.uncertainty * kDegrees
           << " degrees further " << (diagnosis.yaw_error > 0.0 ? "left" : "right")
           << " than tf has it";
      break;
  }
  return text.str();
}

std::string mendedMount(const tf2::BufferCore& buffer, const std::string& base_frame,
                        const std::string& frame, double yaw_error) {
  try {
    const auto mount = buffer.lookupTransform(base_frame, frame, ros::Time(0)).transform;
    const tf2::Quaternion rotation(mount.rotation.x, mount.rotation.y, mount.rotation.z,
                                   mount.rotation.w);
    double roll = 0.0;
    double pitch = 0.0;
    double yaw = 0.0;
    tf2::Matrix3x3(rotation).getRPY(roll, pitch, yaw);
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << "rosrun tf2_ros static_transform_publisher "
         << mount.translation.x << ' ' << mount.translation.y << ' ' << mount.translation.z << ' '
         << core::wrapAngle(yaw + yaw_error) << ' ' << pitch << ' ' << roll << ' ' << base_frame
         << ' ' << frame;
    return text.str();
  } catch (const tf2::TransformException&) {
    return {};
  }
}

void SensorExaminer::add(const core::Scan& scan, core::PlaceId place,
                         const core::Pose2d& place_from_scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.push_back({scan, place, place_from_scan});
  if (waiting_.size() > kMostWaiting) waiting_.pop_front();
}

void SensorExaminer::examineWaiting() {
  std::deque<Waiting> waiting;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting.swap(waiting_);
  }
  for (const Waiting& w : waiting) {
    try {
      doctor_.examine(w.scan, grid_of_(w.place), w.place_from_scan);
    } catch (const std::exception&) {
      continue;  // the place was removed meanwhile
    }
  }
  if (!waiting.empty()) diagnoses_ = doctor_.diagnose();
}

void SensorExaminer::diagnose(const std::vector<SensorHealth>& sensors,
                              const tf2::BufferCore& buffer, const std::string& base_frame,
                              diagnostic_updater::DiagnosticStatusWrapper& status) {
  examineWaiting();
  status.summary(Level::OK, doctor_.scans() == 0
                                ? "no scan was recognized yet"
                                : "nothing found in " + std::to_string(doctor_.scans()) + " scans");
  const auto nameOf = [&](core::SensorId id) {
    const SensorHealth* sensor = find(sensors, id);
    return sensor ? sensor->name : "sensor " + std::to_string(id);
  };
  bool is_well = true;
  for (const core::SensorDiagnosis& diagnosis : diagnoses_) {
    const std::string name = nameOf(diagnosis.sensor);
    const std::string sentence = inWords(diagnosis, name, nameOf(diagnosis.other));
    if (sentence.empty()) continue;
    if (is_well) status.clearSummary();
    is_well = false;
    status.mergeSummary(Level::WARN, sentence);
    const SensorHealth* sensor = find(sensors, diagnosis.sensor);
    if (diagnosis.fault != core::SensorFault::kMountedOff || !sensor) continue;
    const std::string line = mendedMount(buffer, base_frame, sensor->frame, diagnosis.yaw_error);
    if (!line.empty()) status.add(name, line);
  }
  status.add("scans examined", doctor_.scans());
}

}  // namespace place_memory::node
