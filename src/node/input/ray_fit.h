#ifndef PLACE_MEMORY_NODE_INPUT_RAY_FIT_H
#define PLACE_MEMORY_NODE_INPUT_RAY_FIT_H

#include <cstddef>
#include <optional>

#include "node/input/cloud_points.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// Infers how a sensor is mounted of which only the points are known that it heard: they lie along
/// its axis. Where along that it sits they do not tell; it is put nearest to the frame's origin.
class RayFit {
 public:
  /// Only of echoes.
  void add(const CloudPoint& point);

  /// How it is mounted in the frame of the points: along the line through them once enough were
  /// seen that lie apart, before in the origin, towards the newest. Nothing before the first.
  std::optional<core::Pose2d> mount() const;

 private:
  std::optional<core::Pose2d> alongLine() const;

  std::size_t count_ = 0;
  double x_ = 0.0, y_ = 0.0;               // means
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;  // sums of squared differences from the means
  CloudPoint newest_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_RAY_FIT_H
