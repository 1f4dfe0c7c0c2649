#include "core/memory/learned_scans.h"

namespace place_memory::core {
namespace {

bool canBeTold(const Scan& scan) {
  return scan.id != 0 || scan.begin.count() != 0 || scan.end.count() != 0;
}

}  // namespace

PlaceId LearnedScans::find(const Scan& scan) const {
  const auto found = canBeTold(scan) ? places_.find(keyOf(scan)) : places_.end();
  return found == places_.end() ? kNoPlace : found->second;
}

void LearnedScans::add(const Scan& scan, PlaceId place) {
  if (canBeTold(scan)) places_[keyOf(scan)] = place;
}

LearnedScans::Key LearnedScans::keyOf(const Scan& scan) {
  const Pose2d& pose = scan.odom_from_scan;
  if (scan.id != 0) return {scan.id, 0, 0, pose.x, pose.y, pose.yaw};
  return {0, scan.begin.count(), scan.end.count(), pose.x, pose.y, pose.yaw};
}

}  // namespace place_memory::core
