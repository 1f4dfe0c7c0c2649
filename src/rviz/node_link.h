#ifndef PLACE_MEMORY_RVIZ_NODE_LINK_H
#define PLACE_MEMORY_RVIZ_NODE_LINK_H

#include <place_memory/ExploreAction.h>
#include <place_memory/GoToPlaceAction.h>
#include <place_memory/ScanPlaceAction.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <memory>
#include <string>
#include <vector>

#include "rviz/action_link.h"
#include "rviz/board.h"

namespace place_memory::panel {

/// Topics and actions of one node, heard on a thread of its own and written on a board. Making one
/// and ending it takes as long as the master does.
class NodeLink {
 public:
  NodeLink(const std::string& node, const std::shared_ptr<Board>& board);
  ~NodeLink();

  ActionLink<ScanPlaceAction>& scan() { return *scan_; }
  ActionLink<GoToPlaceAction>& goToPlace() { return *go_to_place_; }
  ActionLink<ExploreAction>& explore() { return *explore_; }

  /// Every goal that is under way.
  void cancel();

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle names_;
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<ActionLink<ScanPlaceAction>> scan_;
  std::unique_ptr<ActionLink<GoToPlaceAction>> go_to_place_;
  std::unique_ptr<ActionLink<ExploreAction>> explore_;
  ros::AsyncSpinner spinner_;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_NODE_LINK_H
