#ifndef PLACE_MEMORY_CORE_MEMORY_TWINS_H
#define PLACE_MEMORY_CORE_MEMORY_TWINS_H

#include <cstddef>
#include <functional>
#include <vector>

#include "core/index/place_index.h"
#include "core/recognize/recognizer.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/scan.h"

namespace place_memory::core {

/// A place at which the robot may believe to be at another one.
struct Twin {
  PlaceId place = kNoPlace;  ///< where the robot is
  PlaceId other = kNoPlace;  ///< where it may believe to be
  /// How well the other one fits the place's own scan: 1 as well as the place itself, 0 no better
  /// than the best of the tenth of all places that fit it worst.
  double likeness = 0.0;
  Pose2d other_from_place;  ///< alignment at which it does
  /// Where, seen from the place, the two differ the most: direction in the place's frame [rad] and
  /// distance [m]; 0 where they differ nowhere that both know.
  double parting_bearing = 0.0;
  double parting_distance = 0.0;
  /// A place linked to `place` that tells them apart: the same way from the other one leads to no
  /// place, or to one that is no twin of it. kNoPlace: there is none.
  PlaceId parting_place = kNoPlace;
};

struct TwinOptions {
  std::size_t most = 10;              ///< twins of one place
  double least_likeness = 0.4;        ///< in [0, 1]
  double heading_window = kPi / 4.0;  ///< how far the compass may be off [rad]
};

/// Which places look alike, the most alike first. `scan_of` gives the scan that a place was learned
/// from. Places that would put the robot where it is (within two metres) are no twins.
std::vector<Twin> findTwins(const PlaceMap& map, const PlaceIndex& index,
                            const Recognizer& recognizer,
                            const std::function<Scan(const Place&)>& scan_of,
                            const TwinOptions& options);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_TWINS_H
