#include "node/go/robot_finder.h"

#include <algorithm>
#include <cmath>

#include "node/base/ros_time.h"
#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

// Beyond the doubt that is left on new ground, which may look like known one.
constexpr double kLost = 0.8;

constexpr double kAbout = 3.0;         // a route begins no further from the robot [m]
constexpr double kWorthARoute = 0.02;  // probability of a place

double between(const core::Place& place, const core::Pose2d& robot) {
  const core::Pose2d stand = place.map_from_place * place.place_from_robot;
  return std::hypot(stand.x - robot.x, stand.y - robot.y);
}

}  // namespace

std::optional<core::Pose2d> RobotFinder::mapFromOdom(std::string& problem) const {
  if (driver_.mode() != config::Mode::kOff) {
    const std::optional<core::BeliefSummary> belief = driver_.belief();
    const std::optional<core::Pose2d> map_from_odom = driver_.mapFromOdom();
    if (map_from_odom && !(belief && belief->lost > kLost)) return map_from_odom;
    problem =
        "where on the map the robot is, is not known: drive it some metres, until ~events says "
        "that it is found, or say where it is on initialpose";
    return std::nullopt;
  }
  const core::Whereabouts whereabouts = memory_.whereabouts();
  if (whereabouts.map_from_odom && !whereabouts.apart) return whereabouts.map_from_odom;
  problem =
      "where on the map the robot is, is not known: scan and recognize a place, or set the mode "
      "to localize";
  return std::nullopt;
}

RobotFinder::Found RobotFinder::find(std::chrono::nanoseconds now,
                                     const std::optional<core::Pose2d>& instead) const {
  Found found;
  if (parameters_.odom_frame.empty()) {
    found.problem = "odom_frame is empty: nothing says how the robot drives; name the frame";
    return found;
  }
  const std::optional<core::Pose2d> known = mapFromOdom(found.problem);
  const std::optional<core::Pose2d> map_from_odom = known ? known : instead;
  if (!map_from_odom) return found;
  RobotFix fix;
  fix.is_assumed = !known;
  const auto base =
      lookupNewest(buffer_, parameters_.odom_frame, parameters_.base_frame, fix.stamp);
  if (!base || toSeconds(now - fix.stamp) > parameters_.scan.heading_timeout) {
    found.odometry_is_old = true;
    found.problem = "no fresh transform from " + parameters_.base_frame + " to " +
                    parameters_.odom_frame + ": does what publishes odometry still run?";
    return found;
  }
  fix.odom_from_base = base->pose;
  fix.map_from_base = *map_from_odom * base->pose;
  found.fix = fix;
  found.problem.clear();
  return found;
}

std::vector<core::RouteStart> RobotFinder::starts(
    const RobotFix& fix, const std::vector<core::PlaceId>& unreachable) const {
  std::vector<core::RouteStart> starts;
  const auto is_barred = [&](core::PlaceId id) {
    return std::find(unreachable.begin(), unreachable.end(), id) != unreachable.end();
  };
  const std::optional<core::BeliefSummary> belief = driver_.belief();
  if (belief && driver_.mode() != config::Mode::kOff) {
    for (const core::BelievedPlace& believed : belief->places) {
      const std::optional<core::Place> place = memory_.place(believed.id);
      const bool is_about = place && between(*place, fix.map_from_base) <= kAbout;
      if (is_about && believed.probability >= kWorthARoute && !is_barred(believed.id)) {
        starts.push_back({believed.id, believed.probability});
      }
    }
  }
  if (!starts.empty()) return starts;
  const core::SessionId session = memory_.whereabouts().session;
  double least = 0.0;
  for (const core::Place& place : memory_.map().places) {
    const double distance = between(place, fix.map_from_base);
    if (session != core::kNoSession && place.session != session) continue;
    if (is_barred(place.id) || (!starts.empty() && distance >= least)) continue;
    starts = {{place.id, 1.0}};
    least = distance;
  }
  return starts;
}

}  // namespace place_memory::node
