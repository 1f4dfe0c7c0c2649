#include "core/mapping/moving_scan.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kNewSpot = 0.02;                    // [m]
constexpr double kNewHeading = 2.0 * kPi / 180.0;    // [rad]
constexpr double kAboutMiddle = 0.12;                // share of the stretch
constexpr double kTurnCost = 0.5;                    // [m / (rad/s)]
constexpr std::size_t kMostAtSpot = 48;              // readings
constexpr double kLooksAhead = 170.0 * kPi / 180.0;  // widest gap between sonars of a ring [rad]

}  // namespace

void MovingScanBuilder::add(const BaseMoment& moment, const SonarReading& reading) {
  bool moved = stations_.empty();
  if (!moved) {
    const Pose2d motion = stations_.back().moment.reckoned.inverse() * moment.reckoned;
    moved = std::hypot(motion.x, motion.y) > kNewSpot || std::abs(motion.yaw) > kNewHeading;
  }
  if (moved) stations_.push_back({moment, {}});
  Station& station = stations_.back();
  if (station.readings.size() >= kMostAtSpot) return;
  station.readings.push_back(reading);
  ++kept_;
}

void MovingScanBuilder::restart() {
  stations_.clear();
  kept_ = 0;
  looked_at_ = 0;
  last_scan_ = -1e9;
}

bool MovingScanBuilder::looksAhead() const {
  std::vector<double> bearings;
  for (const Station& station : stations_) {
    for (const SonarReading& reading : station.readings) {
      bearings.push_back(wrapAngle(reading.sensor_pose.yaw));
    }
  }
  std::sort(bearings.begin(), bearings.end());
  double gap = 2.0 * kPi - (bearings.back() - bearings.front());
  for (std::size_t i = 1; i < bearings.size(); ++i) {
    gap = std::max(gap, bearings[i] - bearings[i - 1]);
  }
  return gap >= kLooksAhead;
}

/// About the middle of the way, where the robot turns least: while it turns fast, clocks that
/// differ by a tenth of a second put it elsewhere.
std::size_t MovingScanBuilder::middleOf(std::size_t first) const {
  const double reach = stations_.back().moment.way - stations_[first].moment.way;
  const double middle = stations_.back().moment.way - 0.5 * reach;
  std::size_t best = first;
  double least = INFINITY;
  for (std::size_t i = first; i < stations_.size(); ++i) {
    const double off = std::abs(stations_[i].moment.way - middle);
    const BaseMoment& before = stations_[std::max(i, first + 1) - 1].moment;
    const BaseMoment& after = stations_[std::min(i + 1, stations_.size() - 1)].moment;
    const double seconds = std::chrono::duration<double>(after.stamp - before.stamp).count();
    const double rate = std::abs(after.turn - before.turn) / std::max(seconds, 0.01);
    const double cost = off + (off <= kAboutMiddle * reach ? kTurnCost * rate : reach);
    if (cost >= least) continue;
    least = cost;
    best = i;
  }
  return best;
}

std::optional<MovingScan> MovingScanBuilder::take() {
  if (kept_ == 0) return std::nullopt;
  const double now = stations_.back().moment.way;
  if (now - std::max(last_scan_, stations_.front().moment.way) < options_.spacing) {
    return std::nullopt;
  }
  if (stations_.size() == looked_at_) return std::nullopt;  // nothing but another reading
  looked_at_ = stations_.size();
  while (stations_.size() > 1 && now - stations_[1].moment.way > options_.longest) {
    kept_ -= stations_.front().readings.size();
    stations_.pop_front();
    looked_at_ = 0;
  }
  const bool ahead = looksAhead();
  const double wanted = ahead ? options_.length_ahead : options_.length;
  std::size_t first = stations_.size();
  std::size_t count = 0;
  while (first > 0) {
    if (count >= options_.readings && now - stations_[first - 1].moment.way > wanted) break;
    --first;
    count += stations_[first].readings.size();
  }
  const double reach = now - stations_[first].moment.way;
  const bool enough = count >= options_.readings;
  if (reach < options_.spacing) return std::nullopt;
  if (!enough && reach < options_.longest - options_.spacing) return std::nullopt;
  last_scan_ = now;

  MovingScan scan;
  const std::size_t middle = middleOf(first);
  scan.middle = stations_[middle].moment;
  scan.first_way = stations_[first].moment.way;
  scan.last_way = now;
  scan.enough = enough;
  const Pose2d back = scan.middle.reckoned.inverse();
  auto readings = std::make_shared<std::vector<SonarReading>>();
  readings->reserve(count);
  // By the golden section, which falls into step with no rhythm in which sonars take turns.
  const std::size_t most = ahead ? options_.most_ahead : options_.most;
  const double share = std::min(
      1.0, static_cast<double>(most) / static_cast<double>(std::max<std::size_t>(count, 1)));
  double golden = 0.0;
  for (std::size_t i = first; i < stations_.size(); ++i) {
    const Pose2d middle_from_station = back * stations_[i].moment.reckoned;
    for (SonarReading reading : stations_[i].readings) {
      golden = std::fmod(golden + 0.6180339887498949, 1.0);
      if (golden >= share) continue;
      reading.sensor_pose = middle_from_station * reading.sensor_pose;
      readings->push_back(reading);
    }
    if (i == middle) scan.first_newest = readings->size();
  }
  scan.readings = std::move(readings);
  return scan;
}

}  // namespace place_memory::core
