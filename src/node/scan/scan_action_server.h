#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_ACTION_SERVER_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_ACTION_SERVER_H

#include <actionlib/server/action_server_base.h>
#include <place_memory/ScanPlaceAction.h>
#include <ros/node_handle.h>

namespace place_memory::node {

/// The action protocol of ~scan, for any ROS time and any stamp of a client.
///
/// actionlib's own ActionServer adds up stamps without looking, which throws where one is near the
/// end of what it holds, for good where a cancel is so stamped; publishes its status by ROS time,
/// which may stand still; and refuses every goal after a cancel from the future.
class ScanActionServer : public actionlib::ActionServerBase<ScanPlaceAction> {
 public:
  using OnGoal = boost::function<void(GoalHandle)>;

  /// Takes messages once start() was called. `names`: of the action.
  ScanActionServer(const ros::NodeHandle& names, const OnGoal& on_goal, const OnGoal& on_cancel)
      : ActionServerBase(on_goal, on_cancel), names_(names) {}

 protected:
  void initialize() override;
  void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override;
  void publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) override;
  void publishStatus() override;

 private:
  void onGoal(const ActionGoalConstPtr& goal);
  void onCancel(const actionlib_msgs::GoalID::ConstPtr& goal_id);

  ros::NodeHandle names_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::Publisher statuses_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::SteadyTimer status_timer_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_ACTION_SERVER_H
