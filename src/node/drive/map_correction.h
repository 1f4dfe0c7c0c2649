#ifndef PLACE_MEMORY_NODE_DRIVE_MAP_CORRECTION_H
#define PLACE_MEMORY_NODE_DRIVE_MAP_CORRECTION_H

#include <optional>

#include "config/parameters.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// The transform map_frame -> odom_frame as others are given it: it follows what the drive finds
/// out when the policy has it so.
class MapCorrection {
 public:
  explicit MapCorrection(config::Correct policy) : policy_(policy) {}

  /// The transform as the drive has it; nothing: not known. Returns whether others are given one
  /// that became known anew.
  bool update(const std::optional<core::Pose2d>& map_from_odom) {
    const bool anew = isWanted() && map_from_odom.has_value();
    const bool follows = policy_ == config::Correct::kAlways || anew ||
                         (policy_ == config::Correct::kWhenLost && !map_from_odom);
    if (follows) given_ = map_from_odom;
    if (anew) requested_ = false;
    return anew;
  }

  /// Somebody asked where the robot is, or said so.
  void request() { requested_ = true; }
  /// Nothing: none is given.
  const std::optional<core::Pose2d>& given() const { return given_; }

 private:
  bool isWanted() const {
    return requested_ || (policy_ != config::Correct::kOnRequest && !given_);
  }

  config::Correct policy_;
  bool requested_ = false;
  std::optional<core::Pose2d> given_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_MAP_CORRECTION_H
