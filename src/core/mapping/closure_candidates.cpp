#include "core/mapping/closure_candidates.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr std::size_t kMost = 12;
constexpr double kBegins = 0.3;      ///< probability of a sighting that begins a candidate
constexpr double kSpeaks = 0.05;     ///< from which one speaks for a candidate that is there
constexpr double kMostSaid = 3.0;    ///< by one scan
constexpr double kSoftening = 0.5;   ///< scans err together: published odds are too sure
constexpr double kMissed = 1.0;      ///< what a scan says that should agree and does not
constexpr double kNear = 0.5;        // [m]
constexpr double kNearGrows = 0.06;  // by way since the last witness
constexpr double kTurn = 9.0 * kDegree;
constexpr double kTurnGrows = 1.5 * kDegree;  // [rad/m]

double said(double probability) {
  const double odds = probability / std::max(1.0 - probability, 1e-6);
  return std::clamp(kSoftening * std::log(odds / 0.05), 0.0, kMostSaid);
}

/// Half way between two poses.
Pose2d between(const Pose2d& a, const Pose2d& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          wrapAngle(a.yaw + share * wrapAngle(b.yaw - a.yaw))};
}

std::size_t placesOf(const ClosureCandidate& candidate) {
  std::set<PlaceId> places;
  for (const Witness& witness : candidate.witnesses) places.insert(witness.place);
  return places.size();
}

bool sees(const ClosureCandidate& candidate, PlaceId place) {
  return std::any_of(candidate.witnesses.begin(), candidate.witnesses.end(),
                     [place](const Witness& witness) { return witness.place == place; });
}

bool agrees(const Pose2d& a, const Pose2d& b, double way) {
  return std::hypot(a.x - b.x, a.y - b.y) <= kNear + kNearGrows * way &&
         std::abs(wrapAngle(a.yaw - b.yaw)) <= kTurn + kTurnGrows * way;
}

}  // namespace

void ClosureCandidates::update(std::size_t node, double way, double stretch, const Pose2d& estimate,
                               const std::vector<Sighting>& sightings,
                               const std::function<bool(const Pose2d&)>& at_place) {
  stretch_ = stretch;
  std::vector<char> used(sightings.size(), 0);
  for (ClosureCandidate& candidate : candidates_) {
    const Pose2d expected = candidate.target_from_estimate * estimate;
    const double since = way - candidate.witnesses.back().way;
    const Sighting* best = nullptr;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      if (!agrees(sightings[i].pose, expected, since)) continue;
      used[i] = 1;
      if (sightings[i].probability < kSpeaks) continue;
      if (!best || sightings[i].probability > best->probability) best = &sightings[i];
    }
    if (best) {
      candidate.score += said(best->probability);
      candidate.prior = best->prior;
      candidate.witnesses.push_back({node, best->place, way, best->pose});
      const double share = std::max(0.35, 1.0 / static_cast<double>(candidate.witnesses.size()));
      candidate.target_from_estimate = between(expected, best->pose, share) * estimate.inverse();
    } else if (at_place(expected)) {
      candidate.score -= kMissed;
      ++candidate.misses;
    }
  }
  const auto hopeless = [&](const ClosureCandidate& candidate) {
    return candidate.score < 0.0 || way - candidate.witnesses.back().way > options_.give_up;
  };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), hopeless),
                    candidates_.end());
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (used[i] || sightings[i].probability < kBegins) continue;
    ClosureCandidate candidate;
    candidate.target_from_estimate = sightings[i].pose * estimate.inverse();
    candidate.score = said(sightings[i].probability);
    candidate.prior = sightings[i].prior;
    candidate.witnesses.push_back({node, sightings[i].place, way, sightings[i].pose});
    candidates_.push_back(candidate);
  }
  for (ClosureCandidate& candidate : candidates_) {
    const Pose2d there = candidate.target_from_estimate * estimate;
    candidate.moves = std::hypot(there.x - estimate.x, there.y - estimate.y);
  }
  const auto is_better = [](const ClosureCandidate& a, const ClosureCandidate& b) {
    return a.cut == b.cut ? a.weight() > b.weight() : b.cut;
  };
  std::stable_sort(candidates_.begin(), candidates_.end(), is_better);
  // Of two that have come to mean the same, the better one stays.
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Pose2d here = candidates_[i].target_from_estimate * estimate;
    for (std::size_t j = candidates_.size(); j-- > i + 1;) {
      if (!agrees(candidates_[j].target_from_estimate * estimate, here, 0.0)) continue;
      candidates_[i].cut = candidates_[i].cut || candidates_[j].cut;
      candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
  std::stable_sort(candidates_.begin(), candidates_.end(), is_better);
  if (candidates_.size() > kMost) candidates_.resize(kMost);
}

const ClosureCandidate* ClosureCandidates::foremost() const {
  return candidates_.empty() || candidates_.front().cut ? nullptr : &candidates_.front();
}

const ClosureCandidate* ClosureCandidates::at(PlaceId place) const {
  const auto found = std::find_if(candidates_.begin(), candidates_.end(),
                                  [place](const ClosureCandidate& candidate) {
                                    return !candidate.cut && sees(candidate, place);
                                  });
  return found == candidates_.end() ? nullptr : &*found;
}

bool ClosureCandidates::cut(PlaceId place) {
  bool any = false;
  for (ClosureCandidate& candidate : candidates_) {
    if (candidate.cut || !sees(candidate, place)) continue;
    candidate.cut = true;
    any = true;
  }
  std::stable_partition(candidates_.begin(), candidates_.end(),
                        [](const ClosureCandidate& candidate) { return !candidate.cut; });
  return any;
}

/// The farther off the robot may be, the more rooms there are to mistake; a map of a few places
/// shows one or two of them, and cannot tell.
std::size_t ClosureCandidates::placesAsked(const ClosureCandidate& candidate,
                                           std::size_t known) const {
  const double further = options_.farther > 0.0 ? candidate.moves / options_.farther : 0.0;
  const std::size_t more = std::min(static_cast<std::size_t>(further), options_.more);
  return std::min(options_.places, known) + more;
}

void ClosureCandidates::dropForemost() {
  if (!candidates_.empty()) candidates_.erase(candidates_.begin());
}

const ClosureCandidate* ClosureCandidates::accepted(std::size_t known) const {
  if (empty()) return nullptr;
  const ClosureCandidate& best = candidates_.front();
  // Rooms that look alike do so in every scan: more scans of one do not make up for odometry, other
  // rooms that go on agreeing do.
  const double more = -best.prior;
  const double wanted = std::max(options_.spread, options_.stretches * stretch_) + more;
  const double spread = best.witnesses.back().way - best.witnesses.front().way;
  const auto witnesses = static_cast<double>(best.witnesses.size());
  if (witnesses < static_cast<double>(options_.witnesses) + more || spread < wanted) return nullptr;
  if (best.weight() < options_.score) return nullptr;
  if (placesOf(best) < placesAsked(best, known)) return nullptr;
  if (options_.misses * static_cast<std::size_t>(best.misses) > best.witnesses.size()) {
    return nullptr;
  }
  if (candidates_.size() > 1 && !candidates_[1].cut &&
      candidates_[1].weight() > best.weight() - options_.margin) {
    return nullptr;
  }
  return &best;
}

}  // namespace place_memory::core
