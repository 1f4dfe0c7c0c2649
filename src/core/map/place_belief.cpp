#include "core/map/place_belief.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace place_memory::core {
namespace {

/// Less mass than this of its own is not kept apart from all the others.
constexpr double kNegligible = 1e-9;
constexpr double kSameSpot = 1.0;                    // [m]
constexpr double kSameHeading = 30.0 * kPi / 180.0;  // [rad]

}  // namespace

void PlaceBelief::reset() {
  states_.clear();
  elsewhere_ = 0.5;
  off_map_ = 0.5;
}

void PlaceBelief::setTo(PlaceId id, const Pose2d& place_from_base) {
  states_.clear();
  states_[id] = {1.0, place_from_base};
  elsewhere_ = 0.0;
  off_map_ = 0.0;
}

void PlaceBelief::forget(PlaceId id) {
  const auto found = states_.find(id);
  if (found == states_.end()) return;
  elsewhere_ += found->second.mass;
  states_.erase(found);
}

double PlaceBelief::shareOfEach(const Map& map) const {
  const std::size_t others = map.places > states_.size() ? map.places - states_.size() : 0;
  return others == 0 ? 0.0 : elsewhere_ / static_cast<double>(others);
}

void PlaceBelief::normalize() {
  double all = elsewhere_ + off_map_;
  for (const auto& [id, state] : states_) all += state.mass;
  if (all <= 0.0) {
    reset();
    return;
  }
  for (auto& [id, state] : states_) state.mass /= all;
  elsewhere_ /= all;
  off_map_ /= all;
}

void PlaceBelief::predict(const Pose2d& motion, double share, const Map& map) {
  const double lifted = 1.0 - std::pow(1.0 - options_.lifted, share);
  const double stays = std::pow(options_.off_map_stays, share);
  std::unordered_map<PlaceId, State> moved;
  std::map<PlaceId, double> heaviest;
  double fallen = 0.0;
  // By rising id, so that the sums do not depend on the order of a hash table.
  std::vector<PlaceId> ids;
  for (const auto& [id, state] : states_) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  for (const PlaceId id : ids) {
    const State& state = states_[id];
    const Pose2d pose = map.map_from_place(id) * state.place_from_base * motion;
    const PlaceId to = map.nearest(pose);
    if (to == kNoPlace) {
      fallen += state.mass;
      continue;
    }
    State& target = moved[to];
    target.mass += state.mass;
    if (state.mass > heaviest[to]) {
      heaviest[to] = state.mass;
      target.place_from_base = map.map_from_place(to).inverse() * pose;
    }
  }
  const double anywhere = lifted * (1.0 - off_map_ - fallen) + (1.0 - stays) * (off_map_ + fallen);
  for (auto& [id, state] : moved) state.mass *= 1.0 - lifted;
  elsewhere_ = (1.0 - lifted) * elsewhere_ + anywhere;
  off_map_ = stays * (off_map_ + fallen);
  states_ = std::move(moved);
  if (map.places == 0) {
    off_map_ += elsewhere_;
    elsewhere_ = 0.0;
  } else if (states_.size() >= map.places) {
    const double each = elsewhere_ / static_cast<double>(states_.size());
    for (auto& [id, state] : states_) state.mass += each;
    elsewhere_ = 0.0;
  }
  normalize();
}

void PlaceBelief::measure(const std::vector<BeliefMatch>& matches, double known, double share,
                          const Map& map) {
  const double each = shareOfEach(map);
  double best = -INFINITY;
  for (const BeliefMatch& match : matches) best = std::max(best, match.score);
  const double least = std::pow(options_.floor, share);
  for (auto& [id, state] : states_) {
    const bool matched = std::any_of(matches.begin(), matches.end(),
                                     [&id = id](const BeliefMatch& m) { return m.id == id; });
    if (!matched) state.mass *= least;
  }
  double taken = 0.0;
  for (const BeliefMatch& match : matches) {
    double likelihood =
        std::max(std::exp((match.score - best) / options_.softening), options_.floor);
    const auto found = states_.find(match.id);
    if (found == states_.end()) {
      taken += each;
      states_[match.id] = {each * std::pow(likelihood, share), match.place_from_base};
      continue;
    }
    State& state = found->second;
    const Pose2d& there = state.place_from_base;
    const double off =
        std::hypot(match.place_from_base.x - there.x, match.place_from_base.y - there.y) /
        options_.pose_sigma;
    const double agrees = std::exp(-0.5 * off * off);
    likelihood *= std::max(agrees, options_.pose_floor);
    state.mass *= std::pow(std::max(likelihood, options_.floor), share);
    // Elsewhere in the place is rather another look-alike than where the robot is.
    if (agrees > options_.pose_floor || state.mass < each) {
      state.place_from_base = match.place_from_base;
    }
  }
  elsewhere_ = std::max(elsewhere_ - taken, 0.0) * least;
  const double sure = std::clamp(known, 0.01, 0.99);
  off_map_ *= std::pow((1.0 - sure) / sure, options_.off_map_softening * share);
  normalize();
  for (auto state = states_.begin(); state != states_.end();) {
    if (state->second.mass >= kNegligible) {
      ++state;
      continue;
    }
    elsewhere_ += state->second.mass;
    state = states_.erase(state);
  }
}

double PlaceBelief::probability(PlaceId id, const Map& map) const {
  const auto found = states_.find(id);
  return found == states_.end() ? shareOfEach(map) : found->second.mass;
}

PlaceBelief::Cluster PlaceBelief::largest(const Map& map) const {
  struct Seen {
    PlaceId id;
    double mass;
    Pose2d pose;
  };
  std::vector<Seen> seen;
  for (const auto& [id, state] : states_) {
    seen.push_back({id, state.mass, map.map_from_place(id) * state.place_from_base});
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
    return a.mass != b.mass ? a.mass > b.mass : a.id < b.id;
  });
  if (seen.size() > 64) seen.resize(64);  // the others weigh nothing
  Cluster largest;
  for (const Seen& centre : seen) {
    double mass = 0.0;
    for (const Seen& other : seen) {
      const bool same =
          std::hypot(other.pose.x - centre.pose.x, other.pose.y - centre.pose.y) <= kSameSpot &&
          std::abs(wrapAngle(other.pose.yaw - centre.pose.yaw)) <= kSameHeading;
      mass += same ? other.mass : 0.0;
    }
    if (mass > largest.mass) largest = {centre.id, mass};
  }
  return largest;
}

}  // namespace place_memory::core
