#ifndef PLACE_MEMORY_NODE_MAP_PLACE_HANDLES_H
#define PLACE_MEMORY_NODE_MAP_PLACE_HANDLES_H

#include <interactive_markers/interactive_marker_server.h>
#include <ros/node_handle.h>
#include <visualization_msgs/InteractiveMarker.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "node/names/node_names.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// A disc on the place with a menu of PlaceEntry, in the map frame. It cannot be dragged: where a
/// place lies is found out, not wished for. `is_asked`: whether the robot is there, see
/// core::ClosureQuestion.
visualization_msgs::InteractiveMarker toHandle(const core::Place& place,
                                               const std::string& map_frame, bool is_asked);

/// Lets a person in rviz click the places nearest to the robot, as interactive markers on
/// ~place_handles.
class PlaceHandles {
 public:
  /// Called on a thread of the server, for one click at a time; what it throws is logged.
  using OnChoice = std::function<void(core::PlaceId, PlaceEntry)>;

  /// `count`: of places; 0: nothing is published. `memory` must outlive it.
  PlaceHandles(const ros::NodeHandle& private_node, const core::PlaceMemory& memory,
               std::size_t count, const std::string& map_frame, OnChoice on_choice);

  /// To be called now and then: follows the map, and the robot. Nothing: where it is is not known.
  /// `asked`: places of which a person is asked whether the robot is there.
  void follow(const std::optional<core::Pose2d>& map_from_robot,
              const std::set<core::PlaceId>& asked);

 private:
  /// What of a handle is seen.
  struct Shown {
    std::string label;
    core::Pose2d map_from_place;
    bool is_asked = false;
    bool operator==(const Shown& other) const;
  };

  void show(const core::MapSnapshot& map, const core::Pose2d& map_from_robot);
  std::vector<const core::Place*> shownOf(const core::MapSnapshot& map,
                                          const core::Pose2d& map_from_robot) const;
  void onFeedback(const visualization_msgs::InteractiveMarkerFeedback& feedback) const;

  const core::PlaceMemory& memory_;
  const std::size_t count_;
  const std::string map_frame_;
  const OnChoice on_choice_;
  std::map<core::PlaceId, Shown> shown_;
  std::set<core::PlaceId> asked_;
  std::optional<std::uint64_t> version_;  // of the map that is shown
  core::Pose2d around_;                   // likewise
  std::unique_ptr<interactive_markers::InteractiveMarkerServer> server_;  // ends first
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_PLACE_HANDLES_H
