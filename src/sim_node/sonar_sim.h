#ifndef PLACE_MEMORY_SIM_NODE_SONAR_SIM_H
#define PLACE_MEMORY_SIM_NODE_SONAR_SIM_H

#include <geometry_msgs/Twist.h>
#include <place_memory/CarryRobot.h>
#include <place_memory/MoveChair.h>
#include <place_memory/SetDoor.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>
#include <vector>

#include "sim/robot/simulation.h"
#include "sim_node/robot_driver.h"
#include "sim_node/sim_parameters.h"

namespace place_memory::sim_node {

/// The simulated robot on the wire. Frames: world, where the world's file lies; map, where odometry
/// began; odom; base_link; sonar_0 and so on.
class SonarSim {
 public:
  /// With `simulated_time` it is the one who publishes /clock. Throws std::invalid_argument where
  /// the robot cannot stand at its start.
  SonarSim(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
           const SimParameters& parameters, bool simulated_time);

  /// Until ROS is shut down.
  void run();

 private:
  void advertise();
  void publishStaticTransforms();
  void publishWorld();
  void step();
  void publishBase();
  void onCommand(const geometry_msgs::Twist& command);
  bool onSetDoor(SetDoor::Request& request, SetDoor::Response& response);
  bool onCarryRobot(CarryRobot::Request& request, CarryRobot::Response& response);
  bool onMoveChair(MoveChair::Request& request, MoveChair::Response& response);

  ros::NodeHandle names_;
  ros::NodeHandle private_names_;
  const SimParameters parameters_;
  const bool simulated_time_;
  sim::Simulation simulation_;
  const RobotDriver driver_;

  ros::Time now_;
  ros::Time next_ranges_;
  geometry_msgs::Twist command_;
  ros::Time commanded_;

  ros::Publisher clock_;
  ros::Publisher odometry_;
  ros::Publisher ground_truth_;
  ros::Publisher world_;
  ros::Publisher people_;
  ros::Subscriber command_subscriber_;
  std::vector<ros::ServiceServer> services_;
  tf2_ros::TransformBroadcaster transforms_;
  tf2_ros::StaticTransformBroadcaster static_transforms_;
};

}  // namespace place_memory::sim_node

#endif  // PLACE_MEMORY_SIM_NODE_SONAR_SIM_H
