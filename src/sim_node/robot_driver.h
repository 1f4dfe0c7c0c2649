#ifndef PLACE_MEMORY_SIM_NODE_ROBOT_DRIVER_H
#define PLACE_MEMORY_SIM_NODE_ROBOT_DRIVER_H

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/robot/simulation.h"

namespace place_memory::sim_node {

/// What the driver of the simulated robot says, and how: config/sim.yaml has more of each.
struct DriverOptions {
  enum class Message { kRange, kPointCloud, kPointCloud2, kLaserScan };
  enum class NoEcho { kInfinity, kMaxRange, kZero };
  enum class Compass { kImu, kBearing, kNone };

  Message message = Message::kRange;
  NoEcho no_echo = NoEcho::kInfinity;
  Compass compass = Compass::kImu;
  std::vector<std::string> topics = {"sonar"};  ///< one for all sensors, or one for each
  std::vector<std::string> frames;              ///< of the sensors; empty: sonar_0 and so on
  std::string heading_topic = "heading";
  std::string odom_topic = "odom";
  std::string command_topic = "cmd_vel";
  bool sensor_transforms = true;  ///< of each sensor's mount
  bool odom_transform = true;     ///< odom -> base_link
  sim::LaserModel laser;          ///< of kLaserScan
};

/// Publishes ranges and heading of a simulation as a robot's driver would.
class RobotDriver {
 public:
  RobotDriver(const ros::NodeHandle& names, const DriverOptions& options,
              const std::string& base_frame);

  void publishRanges(sim::Simulation& simulation, const ros::Time& now) const;
  void publishHeading(const sim::Simulation& simulation, double sigma, const ros::Time& now) const;

  /// The frames that the driver broadcasts, each with its pose in the base frame.
  std::vector<std::pair<std::string, core::Pose2d>> mounts(const sim::SensorRing& ring) const;

 private:
  std::string sensorFrame(std::size_t sensor) const;
  void publishCones(const core::SonarSpec& spec, const std::vector<double>& ranges,
                    const ros::Time& now) const;
  template <class Cloud>
  void publishCloud(const sim::SensorRing& ring, const std::vector<double>& ranges,
                    const ros::Time& now) const;
  void publishLaser(const std::vector<double>& ranges, const ros::Time& now) const;
  double said(double range, double max_range) const;

  const DriverOptions options_;
  const std::string base_frame_;
  std::vector<ros::Publisher> ranges_;
  ros::Publisher heading_;
};

}  // namespace place_memory::sim_node

#endif  // PLACE_MEMORY_SIM_NODE_ROBOT_DRIVER_H
