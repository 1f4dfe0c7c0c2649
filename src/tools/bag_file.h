#ifndef PLACE_MEMORY_TOOLS_BAG_FILE_H
#define PLACE_MEMORY_TOOLS_BAG_FILE_H

#include <ros/time.h>
#include <rosbag/bag.h>

#include <string>

#include "config/parameters.h"

namespace place_memory::tools {

/// When the first and the last message of a bag were recorded.
struct BagTimes {
  ros::Time first;
  ros::Time last;

  /// That the bag holds nothing between two times, and what it holds; empty where it does.
  std::string missing(const ros::Time& start, const ros::Time& end) const;
};

/// Opens a bag to be read. Throws std::runtime_error that says what to do where it cannot be: it is
/// not there, was never closed, is damaged, or is none.
void openBag(const std::string& path, rosbag::Bag& bag);

/// Throws std::runtime_error where the bag is empty, or holds one of the topics that the parameters
/// name by another definition of its type, whose messages nobody could read.
BagTimes checkBag(const std::string& path, const config::Parameters& parameters);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_FILE_H
