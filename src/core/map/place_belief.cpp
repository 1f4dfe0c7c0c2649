#include "core/map/place_belief.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace place_memory::core {
namespace {

/// Less mass than this of its own is not kept apart from all the others.
constexpr double kNegligible = 1e-9;
constexpr double kNegligibleShare = 1e-4;  // of an answer
constexpr double kSure = 0.3;         // odometry that is off by less says at which place it is [m]
constexpr double kBeside = 0.6;       // so far from a place the robot stands that is there [m]
constexpr double kReach = 2.5;        // sigma
constexpr double kFarthest = 10.0;    // beyond the region; odometry that is worse says little [m]
constexpr double kLeastShare = 1e-3;  // of the most probable place's
constexpr double kSameSpot = 1.0;     // [m]
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

std::vector<PlaceBelief::Spot> PlaceBelief::spotsAt(const Pose2d& pose, double way,
                                                    const Map& map) const {
  const double sigma = map.sigma(way);
  const bool is_sure = sigma <= kSure;
  std::vector<PlaceLocator::Near> near =
      map.near(pose, options_.region + (is_sure ? 0.0 : std::min(kReach * sigma, kFarthest)));
  if (is_sure && near.size() > 1) near.resize(1);
  std::vector<Spot> spots;
  double all = 0.0;
  const double variance = sigma * sigma, beside = kBeside * kBeside;
  // The less odometry is good for, the more the robot is where the place is.
  const double pull = is_sure ? 0.0 : variance / (variance + beside);
  // Variance grows as the third power of the way.
  const double way_left = way * std::cbrt(1.0 - pull);
  for (const PlaceLocator::Near& place : near) {
    const double farther = place.distance * place.distance - near[0].distance * near[0].distance;
    const double weight = std::exp(-0.5 * farther / (variance + beside));
    if (weight < kLeastShare) break;
    const Pose2d map_from_place = map.map_from_place(place.id);
    const Pose2d there{pose.x + pull * (map_from_place.x - pose.x),
                       pose.y + pull * (map_from_place.y - pose.y), pose.yaw};
    spots.push_back({place.id, weight, {0.0, map_from_place.inverse() * there, way_left}});
    all += weight;
  }
  for (Spot& spot : spots) spot.share /= all;
  return spots;
}

void PlaceBelief::predict(const BeliefMotion& moved_by, const Map& map) {
  const double lifted = 1.0 - std::pow(1.0 - options_.lifted, moved_by.share);
  const double stays = std::pow(options_.off_map_stays, moved_by.share);
  std::unordered_map<PlaceId, State> moved;
  std::map<PlaceId, double> heaviest;
  double fallen = 0.0;
  // By rising id, so that the sums do not depend on the order of a hash table.
  std::vector<PlaceId> ids;
  for (const auto& [id, state] : states_) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  for (const PlaceId id : ids) {
    const State& state = states_[id];
    const Pose2d pose = map.map_from_place(id) * state.place_from_base * moved_by.motion;
    const std::vector<Spot> spots = spotsAt(pose, state.way + moved_by.way, map);
    if (spots.empty()) fallen += state.mass;
    for (const Spot& spot : spots) {
      const double mass = spot.share * state.mass;
      State& target = moved[spot.place];
      const double all = target.mass + mass;
      double& most = heaviest[spot.place];
      if (mass > most) target = spot.state;
      most = std::max(most, mass);
      target.mass = all;
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

double PlaceBelief::likelihoodOf(double score, double best) const {
  return std::max(std::exp((score - best) / options_.softening), options_.floor);
}

void PlaceBelief::measure(const std::vector<BeliefMatch>& matches, double known, double share,
                          const Map& map) {
  if (matches.empty() || known <= 0.0 || map.places == 0) return;
  const double each = shareOfEach(map);
  double best = -INFINITY, worst = INFINITY;
  for (const BeliefMatch& match : matches) {
    best = std::max(best, match.score);
    worst = std::min(worst, match.score);
  }
  const double unmatched = likelihoodOf(worst, best);
  weighOffMap(matches, best, unmatched, known, share, map);
  const double least = std::pow(unmatched, share);
  std::unordered_set<PlaceId> matched;
  for (const BeliefMatch& match : matches) matched.insert(match.id);
  for (auto& [id, state] : states_) {
    if (matched.count(id) == 0) state.mass *= least;
  }
  double taken = 0.0;
  for (const BeliefMatch& match : matches) {
    const double likelihood = likelihoodOf(match.score, best);
    const auto found = states_.find(match.id);
    if (found == states_.end()) {
      taken += each;
      states_[match.id] = {each * std::pow(likelihood, share), match.place_from_base};
    } else {
      weigh(match, likelihood, share, each, map, found->second);
    }
  }
  elsewhere_ = std::max(elsewhere_ - taken, 0.0) * least;
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

void PlaceBelief::weighOffMap(const std::vector<BeliefMatch>& matches, double best,
                              double unmatched, double known, double share, const Map& map) {
  // As likely as a scan of any place is, taken together, the odds that it is of none apart.
  const double others =
      map.places > matches.size() ? static_cast<double>(map.places - matches.size()) : 0.0;
  double all = others * unmatched;
  for (const BeliefMatch& match : matches) all += likelihoodOf(match.score, best);
  const double mean = all / static_cast<double>(std::max(map.places, matches.size()));
  const double sure = std::clamp(known, 0.01, 0.99);
  off_map_ *= std::pow(mean * std::pow((1.0 - sure) / sure, options_.off_map_softening), share);
}

void PlaceBelief::weigh(const BeliefMatch& match, double likelihood, double share, double each,
                        const Map& map, State& state) const {
  const Pose2d& there = state.place_from_base;
  const double off =
      std::hypot(match.place_from_base.x - there.x, match.place_from_base.y - there.y) /
      std::hypot(options_.pose_sigma, map.sigma(state.way));
  const double agrees = std::exp(-0.5 * off * off);
  likelihood *= std::max(agrees, options_.pose_floor);
  state.mass *= std::pow(std::max(likelihood, options_.floor), share);
  // Elsewhere in the place is rather another look-alike than where the robot is.
  if (agrees > options_.pose_floor || state.mass < each) {
    state.place_from_base = match.place_from_base;
    state.way = 0.0;
  }
}

double PlaceBelief::probability(PlaceId id, const Map& map) const {
  const auto found = states_.find(id);
  return found == states_.end() ? shareOfEach(map) : found->second.mass;
}

PlaceBelief::Cluster PlaceBelief::nearest(const Map& map) const {
  std::map<PlaceId, double> masses;
  for (const auto& [id, state] : states_) {
    if (state.mass < kNegligibleShare) continue;
    const auto near = map.near(map.map_from_place(id) * state.place_from_base, options_.region);
    masses[near.empty() ? id : near.front().id] += state.mass;
  }
  Cluster nearest;
  for (const auto& [id, mass] : masses) {
    if (mass > nearest.mass) nearest = {id, mass};
  }
  return nearest;
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
