#include "mapping/mapping_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "config/load_parameters.h"

namespace place_memory::mapping {
namespace {

constexpr double kCarried = 1.0;     // further than this no robot comes in a moment [m]
constexpr double kNearest = 4.0;     // places about to judge by [m]
constexpr double kAstray = 1.0;      // [m]
constexpr double kAstrayTurn = 0.5;  // [rad]

double distance(const core::Pose2d& a, const core::Pose2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Whether the robot is elsewhere than it thinks, relative to the nearest place.
std::optional<bool> astray(const core::Mapper& mapper, const core::Pose2d& online,
                           const MomentRecord& now, const Truth& truth) {
  std::optional<bool> astray;
  double nearest = kNearest;
  for (const core::MappedPlace& place : mapper.places()) {
    const double off = distance(place.map_from_base, online);
    const std::optional<core::Pose2d> was = truth.at(place.stamp);
    if (place.apart || off > nearest || !was) continue;
    nearest = off;
    const core::Pose2d thought = place.map_from_base.inverse() * online;
    const core::Pose2d is = was->inverse() * now.truth;
    astray = distance(thought, is) > kAstray ||
             std::abs(core::wrapAngle(thought.yaw - is.yaw)) > kAstrayTurn;
  }
  return astray;
}

}  // namespace

core::MapperOptions mapperOptions() {
  static const config::Parameters kParameters = config::loadParameters({});
  core::MapperOptions options;
  options.recognizer = kParameters.match.recognizer;
  options.sonar = kParameters.sonar;
  options.keep_way = true;
  return options;
}

void Truth::add(const MappingRun& run) {
  for (const MomentRecord& moment : run.moments) poses_[moment.stamp] = moment.truth;
}

std::optional<core::Pose2d> Truth::at(std::chrono::nanoseconds stamp) const {
  const auto found = poses_.find(stamp);
  return found == poses_.end() ? std::nullopt : std::make_optional(found->second);
}

std::chrono::nanoseconds MappingRecorder::stampOf(const trials::DriveMoment& moment) const {
  return std::chrono::nanoseconds(std::llround((start_ + moment.t) * 1e9));
}

void MappingRecorder::feed(const trials::DriveMoment& moment) {
  MomentRecord now;
  now.stamp = stampOf(moment);
  now.odom = moment.odom;
  now.truth = *moment.truth;
  std::optional<core::Pose2d> goes_on;
  if (!run_.moments.empty()) {
    const MomentRecord& before = run_.moments.back();
    if (before.online) goes_on = *before.online * (before.odom.inverse() * now.odom);
    now.way = before.way + distance(now.odom, before.odom);
    now.carried = distance(now.truth, before.truth) > kCarried;
  }
  truth_.add(now);
  const std::clock_t begin = std::clock();
  if (compass_ && moment.heading) mapper_.addHeading(now.stamp, *moment.heading);
  mapper_.addOdometry(now.stamp, moment.odom);
  for (const core::SonarReading& reading : moment.readings) {
    mapper_.addReading(now.stamp, moment.odom, reading);
  }
  const std::vector<core::ScanDecision> decisions = mapper_.takeDecisions();
  if (const auto map_from_odom = mapper_.mapFromOdom()) now.online = *map_from_odom * moment.odom;
  run_.cpu += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  run_.moments.push_back(now);
  for (const core::ScanDecision& decision : decisions) {
    DecisionRecord record;
    record.decision = decision;
    record.moment = run_.moments.size() - 1;
    const core::ScanNode& node = mapper_.graph().nodes().back();
    record.first_way = now.way - (node.last_way - node.first_way);
    record.last_way = now.way;
    // What makes it give up where it is is judged by where it was till then.
    const std::optional<core::Pose2d> online = now.online ? now.online : goes_on;
    if (online) record.astray = astray(mapper_, *online, now, truth_);
    run_.decisions.push_back(record);
  }
}

MappingRun drive(core::Mapper& mapper, const trials::Drive& drive, const DrivePart& part,
                 Truth& truth) {
  MappingRecorder recorder(mapper, truth, part.compass, part.start);
  const std::size_t last = std::min(part.last, drive.size());
  for (std::size_t i = part.first; i < last; ++i) recorder.feed(drive[i]);
  return recorder.run();
}

}  // namespace place_memory::mapping
