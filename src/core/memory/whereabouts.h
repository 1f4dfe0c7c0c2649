#ifndef PLACE_MEMORY_CORE_MEMORY_WHEREABOUTS_H
#define PLACE_MEMORY_CORE_MEMORY_WHEREABOUTS_H

#include <array>
#include <cstdint>
#include <optional>

#include "place_memory/core/map_change.h"
#include "place_memory/core/whereabouts.h"

namespace place_memory::core {

/// The places of the session `from` belong to `into` from now on.
struct SessionJoin {
  SessionId from = kNoSession;
  SessionId into = kNoSession;
  Pose2d into_from_from;  ///< frame of `from` in that of `into`
};

/// A place at which the robot knew where it was, and where odometry had that place.
struct Stand {
  PlaceId place = kNoPlace;
  Pose2d odom_from_place;
  /// Of the alignment by which the place was recognized, in the place's frame, like
  /// PlaceLink::covariance; all 0 where the place was learned from that very scan.
  std::array<double, 9> covariance{};
};

/// What a new place stands on.
struct Footing {
  SessionId session = kNoSession;
  Pose2d map_from_odom;
  bool apart = false;             ///< see Whereabouts
  std::optional<Stand> previous;  ///< the place that the new one is linked to
  std::uint64_t stretch = 0;      ///< of odometry without a jump; the owner counts them
  bool driven = false;            ///< a drive says where the robot is
};

/// A place that was RECOGNIZED, and the scan by which it was.
struct Sighting {
  Place place;
  Pose2d place_from_scan;
  Pose2d odom_from_scan;
  std::array<double, 9> covariance{};  ///< of the alignment, in the place's frame
};

struct Settled {
  bool superseded = false;
  /// The previous place until now; none while a drive says where the robot is: it tells the ways.
  PlaceId came_from = kNoPlace;
  std::optional<SessionJoin> join;  ///< what the answer says of how two sessions lie
};

/// Keeps where the robot is, by the rules that Whereabouts states. Not thread-safe.
class WhereaboutsOwner {
 public:
  /// `located` false: there is no odometry; all places are of the first session then, and lie at
  /// its origin. `next_session`: a session that no place has had yet.
  WhereaboutsOwner(bool located, bool map_is_empty, SessionId next_session);

  const Whereabouts& now() const { return now_; }

  /// Number of a new question about where the robot is; an answer to an older one than was answered
  /// is overtaken. Learning a place is both.
  std::uint64_t ask() { return ++questions_; }

  /// `next_session`: as for the constructor.
  Footing footing(SessionId next_session) const;
  /// The place was learned on this footing. Returns the join that is to be made where, meanwhile,
  /// the robot was recognized in another session.
  std::optional<SessionJoin> learned(std::uint64_t question, const Footing& footing,
                                     const Place& place, const Pose2d& odom_from_scan);

  Settled recognized(std::uint64_t question, const Sighting& sighting);
  /// Returns whether the answer was overtaken.
  bool notRecognized(std::uint64_t question);

  /// A drive says from here on where the robot is, and no answer does; nothing: it has ended.
  /// `current`: the place at which it is, or nullptr.
  void drive(const std::optional<DriveWhereabouts>& whereabouts, const Place* current);
  bool driven() const { return driven_; }

  /// What odometry says from here on has nothing to do with what it said before.
  void forget(bool map_is_empty);

  /// The map has changed so, and is empty now or not.
  void follow(const MapChange& change, bool map_is_empty);

 private:
  void beginStretch(bool map_is_empty);
  void standAt(const Place& place, const Stand& stand);
  std::optional<SessionJoin> settleFrame(const Sighting& sighting);

  const bool located_;
  bool driven_ = false;  ///< see drive()
  Whereabouts now_;
  std::optional<Stand> previous_;  ///< of now_.previous
  std::uint64_t stretch_ = 0;
  std::uint64_t questions_ = 0;
  std::uint64_t newest_answer_ = 0;  ///< the question that is answered
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_WHEREABOUTS_H
