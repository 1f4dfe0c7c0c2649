#ifndef PLACE_MEMORY_CORE_MAP_PLACE_BELIEF_H
#define PLACE_MEMORY_CORE_MAP_PLACE_BELIEF_H

#include <cstddef>
#include <functional>
#include <unordered_map>
#include <vector>

#include "core/map/place_locator.h"
#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

struct PlaceBeliefOptions {
  double lifted = 0.03;             ///< share that is carried anywhere in an update of a whole scan
  double off_map_stays = 0.8;       ///< of off-map in such an update; the rest may be at any place
  double region = 1.0;              ///< so near to a place a pose is at it [m]
  double softening = 2.5;           ///< score by which a likelihood falls to 1 / e
  double floor = 0.001;             ///< least likelihood of a place, where that of the best is 1
  double off_map_softening = 0.25;  ///< exponent of the odds that the scan is of no place
  double pose_sigma = 1.0;          ///< of a match about where a place was believed to see it [m]
  double pose_floor = 0.03;         ///< what a match elsewhere in the place still counts
};

/// What odometry says of the way between two scans.
struct BeliefMotion {
  Pose2d motion;
  double way = 0.0;    ///< driven, whatever its turns [m]
  double share = 1.0;  ///< of a whole scan's way that this was, in (0, 1]
};

/// Where a scan matched one place.
struct BeliefMatch {
  PlaceId id = kNoPlace;
  double score = 0.0;      ///< higher is better
  Pose2d place_from_base;  ///< of the base there
};

/// Discrete Bayes filter over the places and one state "off the map" (Simmons 1995, Labbe 2013):
/// each place with the pose at which it would see the robot. Only places that have mass of their
/// own or a match are touched, so that an update takes no longer with many places; the others share
/// one number.
class PlaceBelief {
 public:
  struct State {
    double mass = 0.0;
    Pose2d place_from_base;
    double way = 0.0;  ///< of odometry alone since a match [m]
  };

  /// What motion needs to know of the map.
  struct Map {
    std::size_t places = 0;
    /// Of a place that is in the map.
    std::function<Pose2d(PlaceId)> map_from_place;
    /// How far odometry may be off after so long a way [m], 1 sigma; it rises with the way [m].
    std::function<double(double)> sigma;
    /// The places within a distance [m] of a pose, nearest first.
    std::function<std::vector<PlaceLocator::Near>(const Pose2d&, double)> near;
  };

  explicit PlaceBelief(const PlaceBeliefOptions& options) : options_(options) { reset(); }

  /// Nothing is known: the robot may be anywhere, or off the map.
  void reset();
  /// The robot is at a place for sure, as by a person's word.
  void setTo(PlaceId id, const Pose2d& place_from_base);

  /// The place is no more in the map: the robot is at one of the others, or off the map.
  void forget(PlaceId id);

  /// Odometry moved.
  void predict(const BeliefMotion& moved, const Map& map);
  /// A scan was matched. `matches`: its best ones, or all; a place that is not among them fits no
  /// better than the worst of them. `known`: the calibrated probability that it is of any place, in
  /// [0, 1]; 0: the scan tells nothing. `share`: what part of the scan is new, in (0, 1].
  void measure(const std::vector<BeliefMatch>& matches, double known, double share, const Map& map);

  double offMap() const { return off_map_; }
  double probability(PlaceId id, const Map& map) const;
  /// Places with mass of their own.
  const std::unordered_map<PlaceId, State>& states() const { return states_; }
  struct Cluster {
    PlaceId place = kNoPlace;  ///< the most probable of it
    double mass = 0.0;         ///< of all places that put the robot where that does
  };
  /// The largest; kNoPlace where no place has mass of its own.
  Cluster largest(const Map& map) const;
  /// The place to which the robot most probably is nearer than to any other, as the places that it
  /// may see have it, and that probability; kNoPlace where no place has mass of its own.
  Cluster nearest(const Map& map) const;
  /// Off-map plus what is outside the largest cluster.
  double lost(const Map& map) const { return 1.0 - largest(map).mass; }

 private:
  struct Spot {
    PlaceId place = kNoPlace;
    double share = 0.0;
    State state;  ///< but for the mass
  };
  std::vector<Spot> spotsAt(const Pose2d& pose, double way, const Map& map) const;
  double shareOfEach(const Map& map) const;
  double likelihoodOf(double score, double best) const;
  void weighOffMap(const std::vector<BeliefMatch>& matches, double best, double unmatched,
                   double known, double share, const Map& map);
  void weigh(const BeliefMatch& match, double likelihood, double share, double each, const Map& map,
             State& state) const;
  void normalize();

  PlaceBeliefOptions options_;
  std::unordered_map<PlaceId, State> states_;
  double elsewhere_ = 0.0;  ///< mass of all other places together
  double off_map_ = 1.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_PLACE_BELIEF_H
