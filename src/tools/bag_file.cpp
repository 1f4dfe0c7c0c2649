#include "tools/bag_file.h"

#include <nav_msgs/Odometry.h>
#include <ros/message_traits.h>
#include <rosbag/view.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Float64.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace place_memory::tools {
namespace {

// Names are the same with and without the slash: a bag has them resolved, parameters do not.
std::string withoutSlash(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

// Of the types that are read.
std::map<std::string, std::string> definitions() {
  std::map<std::string, std::string> sums;
  const auto add = [&](const auto& message) {
    sums[ros::message_traits::datatype(message)] = ros::message_traits::md5sum(message);
  };
  add(sensor_msgs::Range());
  add(sensor_msgs::PointCloud());
  add(sensor_msgs::PointCloud2());
  add(sensor_msgs::LaserScan());
  add(sensor_msgs::Imu());
  add(sensor_msgs::MagneticField());
  add(std_msgs::Float64());
  add(nav_msgs::Odometry());
  add(tf2_msgs::TFMessage());
  return sums;
}

std::string seconds(const ros::Time& time) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", time.toSec());
  return text;
}

void refuseOtherDefinitions(const std::string& path, rosbag::View& view,
                            const config::Parameters& parameters) {
  std::set<std::string> topics = {"tf", "tf_static", withoutSlash(parameters.heading_topic),
                                  withoutSlash(parameters.odom_topic)};
  for (const std::string& topic : parameters.sonar_topics) topics.insert(withoutSlash(topic));
  const std::map<std::string, std::string> sums = definitions();
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    const auto sum = sums.find(connection->datatype);
    if (topics.count(withoutSlash(connection->topic)) == 0 || sum == sums.end()) continue;
    if (connection->md5sum == sum->second || connection->md5sum == "*") continue;
    throw std::runtime_error("in the bag " + path + " the topic " + connection->topic + " holds " +
                             connection->datatype + " by another definition (md5sum " +
                             connection->md5sum + ", not " + sum->second +
                             "); rosbag fix brings a bag up to date");
  }
}

}  // namespace

std::string BagTimes::missing(const ros::Time& start, const ros::Time& end) const {
  if (start <= last && end >= first) return {};
  return std::string("it lies ") + (end < first ? "before" : "after") +
         " what the bag holds, which is from " + seconds(first) + " to " + seconds(last) + " s";
}

void openBag(const std::string& path, rosbag::Bag& bag) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) {
    throw std::runtime_error("the bag " + path + " is a folder");
  }
  if (std::filesystem::is_regular_file(path, none) && std::filesystem::file_size(path) == 0) {
    throw std::runtime_error("the bag " + path + " is an empty file");
  }
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error("the bag " + path +
                             " was never closed, and has no index; run: rosbag reindex " + path);
  } catch (const std::exception& error) {
    const bool is_active = std::filesystem::path(path).extension() == ".active";
    throw std::runtime_error("cannot read the bag " + path + ": " + error.what() +
                             (is_active ? "; is it still being recorded?" : ""));
  }
}

BagTimes checkBag(const std::string& path, const config::Parameters& parameters) {
  rosbag::Bag bag;
  openBag(path, bag);
  try {
    rosbag::View view(bag);
    if (view.size() == 0) throw std::runtime_error("the bag " + path + " holds no message");
    refuseOtherDefinitions(path, view, parameters);
    return {view.getBeginTime(), view.getEndTime()};
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error("the bag " + path + " is damaged: " + error.what());
  }
}

}  // namespace place_memory::tools
