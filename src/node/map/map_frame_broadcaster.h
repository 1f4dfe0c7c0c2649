#ifndef PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H
#define PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H

#include <ros/node_handle.h>
#include <ros/timer.h>
#include <tf2_ros/transform_broadcaster.h>

#include "config/parameters.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Broadcasts the transform from map_frame to odom_frame on tf, where tf_broadcast asks for it, ten
/// times a second of ROS time for as long as it is known.
///
/// Each is dated ahead by two periods, so that whoever asks for now need not wait.
class MapFrameBroadcaster {
 public:
  /// `memory` and `parameters` must outlive the broadcaster.
  MapFrameBroadcaster(ros::NodeHandle& node, const core::PlaceMemory& memory,
                      const config::Parameters& parameters);

 private:
  void broadcast();

  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Timer timer_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MAP_FRAME_BROADCASTER_H
