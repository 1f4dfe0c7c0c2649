#ifndef PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H
#define PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H

#include <ros/node_handle.h>
#include <ros/timer.h>
#include <tf2_ros/transform_broadcaster.h>

#include <functional>
#include <optional>

#include "config/parameters.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// Broadcasts the transform from map_frame to odom_frame on tf, where tf_broadcast asks for it, at
/// tf_rate for as long as it is known.
///
/// Each is dated ahead by transform_tolerance, so that whoever asks for now need not wait.
class MapFrameBroadcaster {
 public:
  /// The transform as it is now; nothing: not known. Called on the thread of the node's queue.
  using MapFromOdom = std::function<std::optional<core::Pose2d>()>;

  /// `parameters` must outlive the broadcaster.
  MapFrameBroadcaster(ros::NodeHandle& node, MapFromOdom map_from_odom,
                      const config::Parameters& parameters);

 private:
  void broadcast();

  const MapFromOdom map_from_odom_;
  const config::Parameters& parameters_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Timer timer_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H
