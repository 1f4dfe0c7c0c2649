#ifndef PLACE_MEMORY_CORE_MAPPING_CLOSURE_CANDIDATES_H
#define PLACE_MEMORY_CORE_MAPPING_CLOSURE_CANDIDATES_H

#include <cstddef>
#include <functional>
#include <vector>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// How many independent witnesses a closed loop, or a join of sessions, takes.
struct ClosureOptions {
  std::size_t witnesses = 5;  ///< scans that agree
  double spread = 3.0;        ///< way from the first of them to the last [m]; but at least
  double stretches = 1.0;     ///< so many lengths of the scans' stretches, which share readings
  double score = 5.0;         ///< sum of their softened log likelihood ratios and the prior
  double margin = 2.5;        ///< of the score over that of any other candidate
  double give_up = 4.0;       ///< way without a witness after which a candidate is dropped [m]
  std::size_t misses = 3;     ///< of so many scans one that should agree may fail to
  /// That they agree with, of those that there are: rooms look alike, a way through several less
  /// so.
  std::size_t places = 2;
  double farther = 4.0;     ///< for each so far that it moves the robot one more; 0: for none [m]
  double agreement = 0.55;  ///< of the witnesses' scans with the places, on an average
  std::size_t more = 8;     ///< for `farther` at most
};

/// Where one place of the target puts a scan.
struct Sighting {
  PlaceId place = kNoPlace;
  double probability = 0.0;
  Pose2d pose;         ///< of the base, in the target's frame
  double prior = 0.0;  ///< log likelihood that odometry brought the robot there, <= 0
};

/// A scan that agreed with a candidate.
struct Witness {
  std::size_t node = 0;
  PlaceId place = kNoPlace;
  double way = 0.0;  ///< of the scan [m]
  Pose2d pose;       ///< where the place put it
};

/// A rigid transform that would put the robot, where it thinks it is, elsewhere on the map.
struct ClosureCandidate {
  Pose2d target_from_estimate;
  double score = 0.0;
  double prior = 0.0;  ///< of its newest witness
  int misses = 0;      ///< scans at places of the target that did not agree
  double moves = 0.0;  ///< how far from where the robot is thought to be it has it [m]
  std::vector<Witness> witnesses;
  bool cut = false;  ///< by a person's word: nothing comes of it

  /// How much speaks for it.
  double weight() const { return score + prior; }
};

/// Gathers witnesses for closed loops. One look is none: scans that share readings repeat one
/// mistake, and corridors look alike some metres on; so candidates are carried along by odometry
/// and each scan speaks for or against them.
class ClosureCandidates {
 public:
  explicit ClosureCandidates(const ClosureOptions& options) : options_(options) {}

  /// One scan of a stretch of the way [m]: where it is thought to be, and where the target's places
  /// put it, best first. `at_place` tells whether a pose in the target's frame is at a place of the
  /// target, where a scan should agree.
  void update(std::size_t node, double way, double stretch, const Pose2d& estimate,
              const std::vector<Sighting>& sightings,
              const std::function<bool(const Pose2d&)>& at_place);

  /// The candidate for which enough speaks, or nullptr. `known`: places of the target.
  const ClosureCandidate* accepted(std::size_t known) const;
  /// The one for which most speaks, or nullptr.
  const ClosureCandidate* foremost() const;
  bool empty() const { return foremost() == nullptr; }
  const std::vector<ClosureCandidate>& all() const { return candidates_; }
  /// The best of those that have a witness at a place, or nullptr.
  const ClosureCandidate* at(PlaceId place) const;
  /// A person says that those with a witness at a place are wrong: nothing comes of them, nor of
  /// what agrees with them, until they are given up. Whether there were any.
  bool cut(PlaceId place);
  /// Forgets a candidate for good or all: their transforms hold no more.
  void clear() { candidates_.clear(); }
  void dropForemost();
  /// Goes on with another one's candidates, which mean the same here.
  void takeOver(const ClosureCandidates& other) {
    candidates_ = other.candidates_;
    stretch_ = other.stretch_;
  }

  const ClosureOptions& options() const { return options_; }

 private:
  std::size_t placesAsked(const ClosureCandidate& candidate, std::size_t known) const;

  ClosureOptions options_;
  double stretch_ = 0.0;                      ///< length of the newest scan's [m]
  std::vector<ClosureCandidate> candidates_;  ///< by falling weight, then those that were cut
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_CLOSURE_CANDIDATES_H
