#include "sim_node/robot_driver.h"

#include <geometry_msgs/Point32.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/Float64.h>

#include <cmath>

#include "node/base/conversions.h"

namespace place_memory::sim_node {
namespace {

constexpr std::uint32_t kQueueLength = 100;
constexpr double kLaserTurn = 0.1;  // [s]
constexpr double kDegrees = 180.0 / core::kPi;

using Message = DriverOptions::Message;
using NoEcho = DriverOptions::NoEcho;
using Compass = DriverOptions::Compass;

ros::Publisher advertise(ros::NodeHandle& names, Message message, const std::string& topic) {
  switch (message) {
    case Message::kPointCloud:
      return names.advertise<sensor_msgs::PointCloud>(topic, kQueueLength);
    case Message::kPointCloud2:
      return names.advertise<sensor_msgs::PointCloud2>(topic, kQueueLength);
    case Message::kLaserScan:
      return names.advertise<sensor_msgs::LaserScan>(topic, kQueueLength);
    case Message::kRange:
      break;
  }
  return names.advertise<sensor_msgs::Range>(topic, kQueueLength);
}

void resize(sensor_msgs::PointCloud& cloud, std::size_t count) { cloud.points.resize(count); }

void resize(sensor_msgs::PointCloud2& cloud, std::size_t count) {
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(count);
}

void setPoint(sensor_msgs::PointCloud& cloud, std::size_t at, double x, double y) {
  cloud.points[at].x = static_cast<float>(x);
  cloud.points[at].y = static_cast<float>(y);
}

void setPoint(sensor_msgs::PointCloud2& cloud, std::size_t at, double x, double y) {
  sensor_msgs::PointCloud2Iterator<float> point(cloud, "x");
  point += static_cast<int>(at);
  point[0] = static_cast<float>(x);
  point[1] = static_cast<float>(y);
  point[2] = 0.0F;
}

}  // namespace

RobotDriver::RobotDriver(const ros::NodeHandle& names, const DriverOptions& options,
                         const std::string& base_frame)
    : options_(options), base_frame_(base_frame) {
  ros::NodeHandle node(names);
  for (const std::string& topic : options_.topics) {
    ranges_.push_back(advertise(node, options_.message, topic));
  }
  if (options_.compass == Compass::kImu) {
    heading_ = node.advertise<sensor_msgs::Imu>(options_.heading_topic, kQueueLength);
  } else if (options_.compass == Compass::kBearing) {
    heading_ = node.advertise<std_msgs::Float64>(options_.heading_topic, kQueueLength);
  }
}

std::string RobotDriver::sensorFrame(std::size_t sensor) const {
  if (sensor < options_.frames.size()) return options_.frames[sensor];
  return "sonar_" + std::to_string(sensor);
}

std::vector<std::pair<std::string, core::Pose2d>> RobotDriver::mounts(
    const sim::SensorRing& ring) const {
  std::vector<std::pair<std::string, core::Pose2d>> mounts;
  if (!options_.sensor_transforms) return mounts;
  if (options_.message != Message::kRange) {  // points and rays are in the frame of the base
    for (const std::string& frame : options_.frames) mounts.emplace_back(frame, core::Pose2d{});
    return mounts;
  }
  for (int i = 0; i < ring.count; ++i) {
    mounts.emplace_back(sensorFrame(static_cast<std::size_t>(i)), sim::sensorPose(ring, i));
  }
  return mounts;
}

void RobotDriver::publishRanges(sim::Simulation& simulation, const ros::Time& now) const {
  if (options_.message == Message::kLaserScan) {
    publishLaser(simulation.sweepLaser(options_.laser), now);
    return;
  }
  const sim::SensorRing& ring = simulation.robot().ring;
  const std::vector<double> ranges = simulation.fire();
  if (options_.message == Message::kPointCloud) {
    publishCloud<sensor_msgs::PointCloud>(ring, ranges, now);
  } else if (options_.message == Message::kPointCloud2) {
    publishCloud<sensor_msgs::PointCloud2>(ring, ranges, now);
  } else {
    publishCones(ring.spec, ranges, now);
  }
}

double RobotDriver::said(double range, double max_range) const {
  if (!std::isinf(range) || range < 0.0 || options_.no_echo == NoEcho::kInfinity) return range;
  return options_.no_echo == NoEcho::kZero ? 0.0 : max_range;
}

void RobotDriver::publishCones(const core::SonarSpec& spec, const std::vector<double>& ranges,
                               const ros::Time& now) const {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    sensor_msgs::Range message;
    message.header = node::makeHeader(sensorFrame(i), now);
    message.radiation_type = sensor_msgs::Range::ULTRASOUND;
    message.field_of_view = static_cast<float>(spec.field_of_view);
    message.min_range = static_cast<float>(spec.min_range);
    message.max_range = static_cast<float>(spec.max_range);
    message.range = static_cast<float>(said(ranges[i], spec.max_range));
    ranges_[ranges_.size() == 1 ? 0 : i].publish(message);
  }
}

// A cloud has no infinity, so that drivers put what gave no echo at the origin or at the end of the
// range; what is too close is at the origin too.
template <class Cloud>
void RobotDriver::publishCloud(const sim::SensorRing& ring, const std::vector<double>& ranges,
                               const ros::Time& now) const {
  Cloud cloud;
  cloud.header =
      node::makeHeader(options_.frames.empty() ? base_frame_ : options_.frames.front(), now);
  resize(cloud, ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const core::Pose2d mount = sim::sensorPose(ring, static_cast<int>(i));
    const double range = said(ranges[i], ring.spec.max_range);
    const bool at_origin = !std::isfinite(range) || range <= 0.0;
    setPoint(cloud, i, at_origin ? 0.0 : mount.x + range * std::cos(mount.yaw),
             at_origin ? 0.0 : mount.y + range * std::sin(mount.yaw));
  }
  ranges_.front().publish(cloud);
}

void RobotDriver::publishLaser(const std::vector<double>& ranges, const ros::Time& now) const {
  const double step = 2.0 * core::kPi / static_cast<double>(ranges.size());
  sensor_msgs::LaserScan scan;
  scan.header = node::makeHeader(sensorFrame(0), now);
  scan.angle_min = 0.0F;
  scan.angle_increment = static_cast<float>(step);
  scan.angle_max = static_cast<float>(step * static_cast<double>(ranges.size() - 1));
  scan.scan_time = static_cast<float>(kLaserTurn);
  scan.range_min = static_cast<float>(options_.laser.min_range);
  scan.range_max = static_cast<float>(options_.laser.max_range);
  for (const double range : ranges) {
    scan.ranges.push_back(static_cast<float>(said(range, options_.laser.max_range)));
  }
  ranges_.front().publish(scan);
}

void RobotDriver::publishHeading(const sim::Simulation& simulation, double sigma,
                                 const ros::Time& now) const {
  const double heading = simulation.compassHeading();
  if (options_.compass == Compass::kBearing) {
    std_msgs::Float64 bearing;  // clockwise from north
    bearing.data = core::wrapAngle(core::kPi / 2.0 - heading) * kDegrees;
    if (bearing.data < 0.0) bearing.data += 360.0;
    heading_.publish(bearing);
  }
  if (options_.compass != Compass::kImu) return;
  sensor_msgs::Imu message;
  message.header = node::makeHeader(base_frame_, now);
  message.orientation = node::toPose({0.0, 0.0, heading}).orientation;
  message.orientation_covariance[8] = sigma * sigma;
  message.angular_velocity_covariance[0] = -1.0;     // not measured
  message.linear_acceleration_covariance[0] = -1.0;  // not measured
  heading_.publish(message);
}

}  // namespace place_memory::sim_node
