#include "core/memory/frame_consensus.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace place_memory::core {
namespace {

constexpr double kShift = 0.5;  // [m]
constexpr double kShiftPerMetre = 0.1;
constexpr double kTurn = kPi / 12.0;  // [rad]

// How far before a place the point lies that stands for its direction: so an error of the direction
// weighs as much as one of the location where other places are as far away [m].
constexpr double kLever = 2.0;

double wayBetween(const FramePair& one, const FramePair& other) {
  return std::hypot(one.from_from_place.x - other.from_from_place.x,
                    one.from_from_place.y - other.from_from_place.y);
}

FrameConsensus saidBy(const FramePair& pair) {
  return {pair.session, pair.into_from_place * pair.from_from_place.inverse()};
}

std::vector<std::size_t> agreeing(const std::vector<FramePair>& pairs, const FramePair& with) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (agrees(saidBy(with), pairs[i], wayBetween(with, pairs[i]))) found.push_back(i);
  }
  return found;
}

std::size_t witnesses(const std::vector<FramePair>& pairs, const std::vector<std::size_t>& which,
                      std::size_t least) {
  std::set<PlaceId> places;
  std::size_t count = 0;
  for (const std::size_t i : which) {
    if (places.insert(pairs[i].place).second) count += pairs[i].sure ? least : 1;
  }
  return count;
}

/// The transform that fits all of them best, by least squares over their locations and directions.
Pose2d fit(const std::vector<FramePair>& pairs, const std::vector<std::size_t>& which) {
  std::vector<Eigen::Vector2d> into;
  std::vector<Eigen::Vector2d> from;
  for (const std::size_t i : which) {
    for (const double ahead : {0.0, kLever}) {
      const Pose2d point{ahead, 0.0, 0.0};
      const Pose2d there = pairs[i].into_from_place * point;
      const Pose2d here = pairs[i].from_from_place * point;
      into.emplace_back(there.x, there.y);
      from.emplace_back(here.x, here.y);
    }
  }
  Eigen::Vector2d into_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d from_mean = Eigen::Vector2d::Zero();
  for (const auto& point : into) into_mean += point / static_cast<double>(into.size());
  for (const auto& point : from) from_mean += point / static_cast<double>(from.size());
  double dot = 0.0;
  double cross = 0.0;
  for (std::size_t i = 0; i < into.size(); ++i) {
    const Eigen::Vector2d a = from[i] - from_mean;
    const Eigen::Vector2d b = into[i] - into_mean;
    dot += a.dot(b);
    cross += a.x() * b.y() - a.y() * b.x();
  }
  const Pose2d turn{0.0, 0.0, std::atan2(cross, dot)};
  const Pose2d turned_mean = turn * Pose2d{from_mean.x(), from_mean.y(), 0.0};
  return {into_mean.x() - turned_mean.x, into_mean.y() - turned_mean.y, turn.yaw};
}

}  // namespace

bool agrees(const FrameConsensus& consensus, const FramePair& pair, double way) {
  if (pair.session != consensus.session) return false;
  const Pose2d error =
      pair.into_from_place.inverse() * (consensus.into_from_from * pair.from_from_place);
  return std::hypot(error.x, error.y) <= kShift + kShiftPerMetre * way &&
         std::abs(error.yaw) <= kTurn;
}

std::optional<FrameConsensus> frameConsensus(const std::vector<FramePair>& pairs,
                                             std::size_t least) {
  std::vector<std::size_t> best;
  std::size_t most = 0;
  for (const FramePair& pair : pairs) {
    std::vector<std::size_t> found = agreeing(pairs, pair);
    const std::size_t count = witnesses(pairs, found, least);
    if (count <= most) continue;
    most = count;
    best = std::move(found);
  }
  if (most < least || most == 0) return std::nullopt;
  const std::set<std::size_t> members(best.begin(), best.end());
  std::size_t second = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (members.count(i) > 0) continue;
    second = std::max(second, witnesses(pairs, agreeing(pairs, pairs[i]), least));
  }
  if (most < 2 * second) return std::nullopt;
  return FrameConsensus{pairs[best.front()].session, fit(pairs, best)};
}

}  // namespace place_memory::core
