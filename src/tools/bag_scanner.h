#ifndef PLACE_MEMORY_TOOLS_BAG_SCANNER_H
#define PLACE_MEMORY_TOOLS_BAG_SCANNER_H

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>

#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/scan/scan_collector.h"

namespace place_memory::tools {

/// Takes scans from a bag with the collector that the node uses.
class BagScanner {
 public:
  /// `parameters` must outlive the scanner. Throws std::runtime_error where the bag cannot be read
  /// or lacks a topic.
  BagScanner(const std::string& path, const config::Parameters& parameters);

  /// Every usable reading between two times, by its stamp.
  node::ScanOutcome scan(const ros::Time& start, const ros::Time& end) const;

 private:
  void requireTopics(const std::string& path);
  void readStaticTransforms();

  const config::Parameters& parameters_;
  rosbag::Bag bag_;
  std::vector<std::string> topics_;        // to be read, as the bag names them
  std::vector<std::string> sonar_topics_;  // without their slashes
  std::string heading_topic_;              // likewise
  std::vector<geometry_msgs::TransformStamped> static_transforms_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_SCANNER_H
