#ifndef PLACE_MEMORY_NODE_MAP_MAP_PUBLISHER_H
#define PLACE_MEMORY_NODE_MAP_MAP_PUBLISHER_H

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <mutex>
#include <optional>

#include "config/parameters.h"
#include "node/map/rated_task.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// Publishes the map, which lies in map_frame: each change on ~map_changes as it is made, the whole
/// on ~place_graph and ~place_markers once a second at most, from a thread of its own. Thread-safe.
class MapPublisher {
 public:
  /// Where the robot is in the map now; nothing: not known. Called on the publisher's thread.
  using LocateRobot = std::function<std::optional<core::Pose2d>()>;

  /// `memory` and `parameters` must outlive the publisher, and no change may be asked for once its
  /// destructor is called. Publishes the map as it is.
  MapPublisher(ros::NodeHandle& private_node, core::PlaceMemory& memory,
               const config::Parameters& parameters, LocateRobot locate_robot);

  /// To be called now and then: labels follow the robot, where not all places have one.
  void follow();

 private:
  void publishChange(const core::MapChange& change);
  void publishWholeMap();

  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;
  const LocateRobot locate_robot_;

  ros::Publisher map_changes_;
  ros::Publisher place_graph_;
  ros::Publisher place_markers_;
  std::mutex mutex_;
  std::optional<core::Pose2d> labels_around_;  // where the robot was when they were published
  bool all_labelled_ = true;                   // likewise
  RatedTask whole_map_;                        // ends before what it uses
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MAP_PUBLISHER_H
