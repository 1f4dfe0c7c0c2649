#include "tools/drive_tables.h"

#include <cinttypes>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "support/csv.h"

namespace place_memory::tools {
namespace {

std::string fixed(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

// To .1 mm and .6 thousandths of a degree.
std::string inFields(const core::Pose2d& pose) {
  return fixed(pose.x, 4) + ',' + fixed(pose.y, 4) + ',' + fixed(core::wrapAngle(pose.yaw), 5);
}

}  // namespace

DriveTable::DriveTable(std::string path, const std::string& header) : path_(std::move(path)) {
  if (path_.empty()) return;
  file_.open(path_);
  add(header);
  file_.flush();
  check();
}

void DriveTable::add(const std::string& row) {
  if (!path_.empty()) file_ << row << '\n';
}

void DriveTable::close() {
  if (path_.empty()) return;
  file_.close();
  check();
}

void DriveTable::check() const {
  if (!file_) throw std::runtime_error("cannot write the table " + path_);
}

std::string inSeconds(std::chrono::nanoseconds stamp) {
  const std::int64_t ms = (stamp.count() + 500000) / 1000000;
  char text[64];
  std::snprintf(text, sizeof text, "%" PRId64 ".%03" PRId64, ms / 1000, ms % 1000);
  return text;
}

std::string trajectoryRow(std::chrono::nanoseconds stamp,
                          const std::optional<core::Pose2d>& map_from_base, double lost) {
  return inSeconds(stamp) + ',' + (map_from_base ? inFields(*map_from_base) : std::string(",,")) +
         ',' + fixed(lost, 4);
}

std::string finalRow(std::chrono::nanoseconds stamp, const core::Pose2d& map_from_base) {
  return inSeconds(stamp) + ',' + inFields(map_from_base);
}

std::string mapRow(const core::MappedPlace& place, const std::string& label) {
  return std::to_string(place.id) + ',' + support::csvField(label) + ',' + inSeconds(place.stamp) +
         ',' + inFields(place.map_from_base);
}

std::string answerRow(const core::ScanDecision& decision) {
  const bool named = decision.place != core::kNoPlace;
  return inSeconds(decision.stamp) + ',' + core::nameOf(decision.kind) + ',' +
         (named ? std::to_string(decision.place) + ',' + inFields(decision.place_from_base)
                : std::string(",,,")) +
         ',' + fixed(decision.belief, 4) + ',' + fixed(decision.lost, 4) + ',' +
         support::csvField(decision.reason);
}

}  // namespace place_memory::tools
