#ifndef PLACE_MEMORY_CORE_WHEREABOUTS_H
#define PLACE_MEMORY_CORE_WHEREABOUTS_H

#include <cstdint>
#include <optional>
#include <string>

#include "place_memory/core/place.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Where the robot is, as far as it is known: one value that PlaceMemory owns.
///
/// With an empty store odometry's frame is the map's. With places known, where odometry began is
/// unknown until a place is RECOGNIZED; a place that is learned before that begins a session of its
/// own, whose frame is odometry's. Once a place of another session is RECOGNIZED the two are
/// joined: the places of the later session are moved to where they belong in the earlier one's
/// frame. What was overtaken, by a newer scan learned or recognized or by a jump, changes nothing.
struct Whereabouts {
  /// Rises with every change, and with every answer that was not overtaken: of two answers the
  /// newer one has the higher version.
  std::uint64_t version = 0;
  /// In whose frame the next place is learned; kNoSession: that place begins a new one.
  SessionId session = kNoSession;
  /// Odometry's frame in the session's; nothing: unknown. Identity where there is no odometry.
  std::optional<Pose2d> map_from_odom;
  /// Whether the session was begun because map_from_odom was not known, and is not joined yet.
  bool apart = false;
  PlaceId previous = kNoPlace;  ///< learned or RECOGNIZED last; the next place is linked to it
  /// Where the newest answer says the robot is: learned or RECOGNIZED; kNoPlace: the newest answer
  /// is not RECOGNIZED, or there is none.
  PlaceId current = kNoPlace;
  std::string current_label;  ///< of `current`, as it is called now; "" where that is kNoPlace
};

/// Where a robot that drives along with the map is, as whoever follows its way has it.
struct DriveWhereabouts {
  /// Odometry's frame in the map's, or where `apart`, in that of the session; nothing: unknown.
  std::optional<Pose2d> map_from_odom;
  bool apart = false;              ///< in a session of its own, not joined to the map yet
  SessionId session = kNoSession;  ///< that one
  PlaceId current = kNoPlace;      ///< at which the robot is; kNoPlace: between places
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_WHEREABOUTS_H
