#ifndef PLACE_MEMORY_NODE_INPUT_INPUT_MESSAGE_H
#define PLACE_MEMORY_NODE_INPUT_INPUT_MESSAGE_H

#include <nav_msgs/Odometry.h>
#include <ros/message_traits.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Float64.h>

#include <exception>
#include <string>
#include <variant>

namespace place_memory::node {

/// A message of one of the types that are understood, or of another one.
struct InputMessage {
  std::string type;     ///< as "sensor_msgs/Range"
  std::string problem;  ///< why one of a known type cannot be read; empty: it can
  std::variant<std::monostate, sensor_msgs::Range::ConstPtr, sensor_msgs::PointCloud::ConstPtr,
               sensor_msgs::PointCloud2::ConstPtr, sensor_msgs::LaserScan::ConstPtr,
               sensor_msgs::Imu::ConstPtr, sensor_msgs::MagneticField::ConstPtr,
               std_msgs::Float64::ConstPtr, nav_msgs::Odometry::ConstPtr>
      content;
};

/// Reads the message if it is of that type; false: it is of another one.
template <class Content, class Source>
bool readAs(const Source& source, InputMessage& message) {
  if (message.type != ros::message_traits::DataType<Content>::value()) return false;
  if (const auto content = source.template instantiate<Content>()) {
    message.content = boost::shared_ptr<const Content>(content);
  } else {
    message.problem = "it is " + message.type + " by another definition than here";
  }
  return true;
}

/// `Source`: RawMessage or rosbag::MessageInstance.
template <class Source>
InputMessage readMessage(const Source& source) {
  InputMessage message;
  message.type = source.getDataType();
  try {
    static_cast<void>(readAs<sensor_msgs::Range>(source, message) ||
                      readAs<sensor_msgs::PointCloud>(source, message) ||
                      readAs<sensor_msgs::PointCloud2>(source, message) ||
                      readAs<sensor_msgs::LaserScan>(source, message) ||
                      readAs<sensor_msgs::Imu>(source, message) ||
                      readAs<sensor_msgs::MagneticField>(source, message) ||
                      readAs<std_msgs::Float64>(source, message) ||
                      readAs<nav_msgs::Odometry>(source, message));
  } catch (const std::exception& error) {  // cut short, or its sizes are lies
    message.problem = std::string("it cannot be read: ") + error.what();
  }
  return message;
}

/// The same of a message that is there already.
template <class Content>
InputMessage inputMessage(const Content& content) {
  InputMessage message;
  message.type = ros::message_traits::DataType<Content>::value();
  message.content = boost::shared_ptr<const Content>(new Content(content));
  return message;
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_INPUT_MESSAGE_H
