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

std::chrono::nanoseconds stampOf(double t) {
  return std::chrono::nanoseconds(std::llround(t * 1e9));
}

double distance(const core::Pose2d& a, const core::Pose2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Whether the robot is elsewhere than it thinks, relative to the nearest place.
std::optional<bool> astray(const core::Mapper& mapper, const MomentRecord& now,
                           const Truth& truth) {
  if (!now.online) return std::nullopt;
  std::optional<bool> astray;
  double nearest = kNearest;
  for (const core::MappedPlace& place : mapper.places()) {
    const double off = distance(place.map_from_base, *now.online);
    const std::optional<core::Pose2d> was = truth.at(place.stamp);
    if (place.apart || off > nearest || !was) continue;
    nearest = off;
    const core::Pose2d thought = place.map_from_base.inverse() * *now.online;
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

MappingRun drive(core::Mapper& mapper, const trials::Drive& drive, const DrivePart& part,
                 Truth& truth) {
  MappingRun run;
  const std::size_t last = std::min(part.last, drive.size());
  double way = 0.0;
  MappingRun known;  // of which the truth knows already
  std::clock_t used = 0;
  for (std::size_t i = part.first; i < last; ++i) {
    const trials::DriveMoment& moment = drive[i];
    MomentRecord now;
    now.stamp = stampOf(part.start + moment.t);
    now.odom = moment.odom;
    now.truth = *moment.truth;
    if (i > part.first) {
      way += distance(moment.odom, drive[i - 1].odom);
      now.carried = distance(*moment.truth, *drive[i - 1].truth) > kCarried;
    }
    now.way = way;
    known.moments.assign(1, now);
    truth.add(known);
    const std::clock_t begin = std::clock();
    if (part.compass && moment.heading) mapper.addHeading(now.stamp, *moment.heading);
    mapper.addOdometry(now.stamp, moment.odom);
    for (const core::SonarReading& reading : moment.readings) {
      mapper.addReading(now.stamp, moment.odom, reading);
    }
    const std::vector<core::ScanDecision> decisions = mapper.takeDecisions();
    if (const auto map_from_odom = mapper.mapFromOdom()) now.online = *map_from_odom * moment.odom;
    used += std::clock() - begin;
    run.moments.push_back(now);
    for (const core::ScanDecision& decision : decisions) {
      DecisionRecord record;
      record.decision = decision;
      record.moment = run.moments.size() - 1;
      const core::ScanNode& node = mapper.graph().nodes().back();
      record.first_way = way - (node.last_way - node.first_way);
      record.last_way = way;
      record.astray = astray(mapper, now, truth);
      run.decisions.push_back(record);
    }
  }
  run.cpu = static_cast<double>(used) / CLOCKS_PER_SEC;
  return run;
}

}  // namespace place_memory::mapping
