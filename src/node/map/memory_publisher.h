#ifndef PLACE_MEMORY_NODE_MAP_MEMORY_PUBLISHER_H
#define PLACE_MEMORY_NODE_MAP_MEMORY_PUBLISHER_H

#include <place_memory/Recognition.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <mutex>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/scan.h"

namespace place_memory::node {

/// Publishes what the memory knows on the node's latched topics. Thread-safe.
///
/// The map is in map_frame. The scan lies in the frame of odometry, where there is one, and the
/// recalled place is laid over it where it aligns.
class MemoryPublisher {
 public:
  /// `memory` and `parameters` must outlive the publisher. Publishes the map as it is.
  MemoryPublisher(ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                  const config::Parameters& parameters);

  /// A scan that is finished or under way.
  void publishScan(const core::Scan& scan);

  /// The map has changed.
  void publishMap();

  /// The robot is in the place it has just learned; the map has changed.
  void publishLearned(core::PlaceId id);

  /// `message` is `recognition` as it is answered.
  void publishRecognition(const core::Scan& scan, const core::PlaceMemory::Answer& answer,
                          const Recognition& message);

 private:
  void publishCurrentPlaceLocked();
  void publishMatchedGrid(const core::Scan& scan, const core::PlaceMatch& match);
  const std::string& scanFrame() const;

  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;

  ros::Publisher scan_grid_;
  ros::Publisher matched_grid_;
  ros::Publisher place_graph_;
  ros::Publisher place_markers_;
  ros::Publisher recognition_;
  ros::Publisher current_place_;
  ros::Publisher pose_;

  /// Held while the map is read and published, so that the last map published is the newest.
  std::mutex mutex_;
  core::PlaceId current_ = core::kNoPlace;
  std::optional<std::string> published_label_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MEMORY_PUBLISHER_H
