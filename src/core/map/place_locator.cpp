#include "core/map/place_locator.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {

std::int64_t PlaceLocator::indexOf(double coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / bucket_));
}

void PlaceLocator::put(PlaceId id, const Pose2d& pose) {
  const Spot spot{pose.x, pose.y};
  const auto [found, is_new] = spots_.emplace(id, spot);
  if (!is_new) {
    leaveBucket(id, found->second);
    found->second = spot;
  }
  buckets_[keyOf(indexOf(spot.x), indexOf(spot.y))].push_back(id);
}

void PlaceLocator::leaveBucket(PlaceId id, const Spot& spot) {
  const auto bucket = buckets_.find(keyOf(indexOf(spot.x), indexOf(spot.y)));
  std::vector<PlaceId>& ids = bucket->second;
  ids.erase(std::remove(ids.begin(), ids.end(), id), ids.end());
  if (ids.empty()) buckets_.erase(bucket);
}

void PlaceLocator::erase(PlaceId id) {
  const auto found = spots_.find(id);
  if (found == spots_.end()) return;
  leaveBucket(id, found->second);
  spots_.erase(found);
}

std::vector<PlaceLocator::Near> PlaceLocator::near(const Pose2d& pose, double radius) const {
  std::vector<Near> found;
  for (std::int64_t column = indexOf(pose.x - radius); column <= indexOf(pose.x + radius);
       ++column) {
    for (std::int64_t row = indexOf(pose.y - radius); row <= indexOf(pose.y + radius); ++row) {
      const auto bucket = buckets_.find(keyOf(column, row));
      if (bucket == buckets_.end()) continue;
      for (const PlaceId id : bucket->second) {
        const Spot& spot = spots_.at(id);
        const double distance = std::hypot(spot.x - pose.x, spot.y - pose.y);
        if (distance <= radius) found.push_back({id, distance});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  });
  // Buckets whose keys meet are one.
  found.erase(std::unique(found.begin(), found.end(),
                          [](const Near& a, const Near& b) { return a.id == b.id; }),
              found.end());
  return found;
}

}  // namespace place_memory::core
