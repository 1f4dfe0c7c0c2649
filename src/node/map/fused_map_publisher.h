#ifndef PLACE_MEMORY_NODE_MAP_FUSED_MAP_PUBLISHER_H
#define PLACE_MEMORY_NODE_MAP_FUSED_MAP_PUBLISHER_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "config/parameters.h"
#include "core/mapping/fused_map.h"
#include "node/base/guarded_queue.h"
#include "node/map/rated_task.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Publishes the building's map as map_server does: ~map and ~map_metadata, latched, and the
/// service ~static_map, all of the same message. It follows the memory's changes on a thread of its
/// own, map/pause apart at least. Thread-safe.
class FusedMapPublisher {
 public:
  /// `memory` and `parameters` must outlive the publisher, and no change may be asked for once its
  /// destructor is called.
  FusedMapPublisher(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
                    const config::Parameters& parameters);
  ~FusedMapPublisher();
  FusedMapPublisher(const FusedMapPublisher&) = delete;
  FusedMapPublisher& operator=(const FusedMapPublisher&) = delete;

  /// The size of the map; WARN where places lie too far off to be on it.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void collect(const core::MapChange& change);
  std::shared_ptr<const core::EvidenceGrid> gridOf(core::PlaceId id) const;
  /// Brings the fused map up to the newest change.
  void follow();
  void publish();
  void warnOfLeftOut(std::size_t left_out) const;
  bool answer(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);

  core::PlaceMemory& memory_;
  const config::Parameters& parameters_;
  GuardedQueue queue_{"maps"};  ///< outlives what is advertised with it
  ros::Publisher map_;
  ros::Publisher metadata_;

  mutable std::mutex mutex_;              ///< guards everything down to stopped_
  std::vector<core::MapChange> changes_;  ///< that the fused map has not seen
  nav_msgs::OccupancyGridConstPtr newest_;
  std::size_t left_out_ = 0;  ///< places, of that message
  bool stopped_ = false;
  std::condition_variable published_;

  core::FusedMap fused_;  ///< the task's
  bool begun_ = false;    ///< likewise: whether it has the places that were there at the start
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
  RatedTask task_;  ///< ends before what it uses
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_FUSED_MAP_PUBLISHER_H
