#include "tools/bag_file.h"

#include <nav_msgs/Odometry.h>
#include <ros/message_traits.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Float64.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string_view>

namespace place_memory::tools {
namespace {

constexpr std::string_view kAnyBag = "#ROS";
constexpr std::string_view kBag = "#ROSBAG V2";  // not of the first years of ROS

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
  sums["tf/tfMessage"] = sums["tf2_msgs/TFMessage"];  // what it was called before
  return sums;
}

// About a bag that rosbag's own words say too little of.
std::string whatToDo(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return "";
  if (std::filesystem::path(path).extension() == ".active") return "; is it still being recorded?";
  std::string begin(kBag.size(), '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin.substr(0, kAnyBag.size()) != kAnyBag) return ": it is no bag of ROS 1";
  if (begin != kBag) return "";
  return ": it is damaged, or ends early; was it copied whole? If so, run: rosbag reindex " + path;
}

}  // namespace

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
    throw std::runtime_error("cannot read the bag " + path + ": " + error.what() + whatToDo(path));
  }
}

void refuseOtherDefinition(const std::string& path, const rosbag::ConnectionInfo& connection) {
  static const std::map<std::string, std::string> sums = definitions();
  const auto sum = sums.find(connection.datatype);
  if (sum == sums.end() || connection.md5sum == sum->second) return;
  throw std::runtime_error("in the bag " + path + " the topic " + connection.topic + " holds " +
                           connection.datatype + " by another definition (md5sum " +
                           connection.md5sum + ", not " + sum->second +
                           "); rosbag fix brings a bag up to date");
}

}  // namespace place_memory::tools
