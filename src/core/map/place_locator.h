#ifndef PLACE_MEMORY_CORE_MAP_PLACE_LOCATOR_H
#define PLACE_MEMORY_CORE_MAP_PLACE_LOCATOR_H

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Where places lie, in buckets: which are near a spot takes no longer where there are many.
class PlaceLocator {
 public:
  struct Near {
    PlaceId id = kNoPlace;
    double distance = 0.0;  ///< [m]
  };

  /// `bucket`: about as wide as what is asked for [m], > 0.
  explicit PlaceLocator(double bucket) : bucket_(bucket) {}

  std::size_t size() const { return spots_.size(); }
  /// Adds a place, or moves it.
  void put(PlaceId id, const Pose2d& pose);
  void erase(PlaceId id);

  /// Within `radius` [m] of x and y, nearest first; as far off, the lower id first.
  std::vector<Near> near(const Pose2d& pose, double radius) const;

 private:
  struct Spot {
    double x, y;
  };
  std::int64_t keyOf(std::int64_t column, std::int64_t row) const {
    return column * 0x1f1f1f1f1 + row;
  }
  std::int64_t indexOf(double coordinate) const;
  void leaveBucket(PlaceId id, const Spot& spot);

  double bucket_;
  std::unordered_map<PlaceId, Spot> spots_;
  std::unordered_map<std::int64_t, std::vector<PlaceId>> buckets_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_PLACE_LOCATOR_H
