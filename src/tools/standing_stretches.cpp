#include "tools/standing_stretches.h"

#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace place_memory::tools {
namespace {

bool isNear(const TrackPoint& point, const TrackPoint& stop, double radius) {
  return std::hypot(point.x - stop.x, point.y - stop.y) <= radius;
}

double secondsBetween(const TrackPoint& from, const TrackPoint& to) {
  return to.stamp.toSec() - from.stamp.toSec();
}

/// One past the last point that belongs to a stretch which begins with `begin`.
std::size_t endOfStretch(const std::vector<TrackPoint>& track, std::size_t begin,
                         const StandingOptions& options) {
  std::size_t end = begin + 1;
  while (end < track.size() && isNear(track[end], track[begin], options.radius) &&
         secondsBetween(track[end - 1], track[end]) <= options.gap) {
    ++end;
  }
  return end;
}

}  // namespace

std::vector<Stretch> standingStretches(const std::vector<TrackPoint>& track,
                                       const StandingOptions& options) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < track.size();) {
    const std::size_t end = endOfStretch(track, i, options);
    if (secondsBetween(track[i], track[end - 1]) < options.shortest) {
      ++i;
      continue;
    }
    const ros::Time longest = track[i].stamp + ros::Duration(options.longest);
    stretches.push_back({track[i].stamp, std::min(track[end - 1].stamp, longest)});
    i = end;
  }
  return stretches;
}

std::vector<TrackPoint> readTrack(const BagSet& bags, const config::Parameters& parameters) {
  std::vector<TrackPoint> track;
  const std::string odom_frame = withoutSlash(parameters.odom_frame);
  const auto add = [&](const ros::Time& stamp, double x, double y) {
    if (std::isfinite(x) && std::isfinite(y)) track.push_back({stamp, x, y});
  };
  if (!parameters.odom_topic.empty()) {
    bags.readAll(withoutSlash(parameters.odom_topic), [&](const TimedMessage& timed) {
      const auto odometry = timed.trusted ? timed.message->as<nav_msgs::Odometry>() : nullptr;
      if (!odometry) return;
      const auto& at = odometry->pose.pose.position;
      add(odometry->header.stamp, at.x, at.y);
    });
  }
  bags.readAll("tf", [&](const TimedMessage& timed) {
    const auto moved = timed.trusted ? timed.message->as<tf2_msgs::TFMessage>() : nullptr;
    if (!moved) return;
    for (const auto& transform : moved->transforms) {
      if (withoutSlash(transform.header.frame_id) != odom_frame) continue;
      const auto& at = transform.transform.translation;
      add(transform.header.stamp, at.x, at.y);
    }
  });
  if (track.empty()) {
    throw std::runtime_error("in " + bags.name() + " there is no tf from the frame " +
                             parameters.odom_frame + ", by which to find where the robot stands");
  }
  std::stable_sort(track.begin(), track.end(),
                   [](const TrackPoint& a, const TrackPoint& b) { return a.stamp < b.stamp; });
  return track;
}

std::vector<Event> findEvents(const BagSet& bags, const config::Parameters& parameters) {
  if (parameters.odom_frame.empty()) {
    throw std::runtime_error("without odometry (odom_frame) a table --events is needed");
  }
  StandingOptions options;
  options.longest = std::max(options.shortest, parameters.scan.timeout);
  std::vector<Event> events;
  for (const Stretch& stretch : standingStretches(readTrack(bags, parameters), options)) {
    Event event;
    event.start = stretch.start;
    event.end = stretch.end;
    event.action = Action::kRecognize;
    event.heading_window = parameters.match.heading_window;
    event.visit = true;
    events.push_back(event);
  }
  if (events.empty()) {
    throw std::runtime_error("in " + bags.name() + " the robot never stands for " +
                             std::to_string(options.shortest).substr(0, 3) +
                             " s; a table --events says which scans to take");
  }
  return events;
}

}  // namespace place_memory::tools
