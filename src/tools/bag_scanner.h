#ifndef PLACE_MEMORY_TOOLS_BAG_SCANNER_H
#define PLACE_MEMORY_TOOLS_BAG_SCANNER_H

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>

#include <chrono>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/input/message_intake.h"
#include "node/input/sensor_registry.h"
#include "node/scan/scan_collector.h"

namespace place_memory::tools {

/// Takes scans from a bag with the collector that the node uses.
class BagScanner {
 public:
  /// `parameters` must outlive the scanner. Throws std::runtime_error where the bag cannot be read
  /// or lacks a topic.
  BagScanner(const std::string& path, const config::Parameters& parameters);

  /// Every usable reading between two times, by its stamp.
  node::ScanOutcome scan(const ros::Time& start, const ros::Time& end);

 private:
  void requireTopics(const std::string& path);
  void readStaticTransforms();
  void take(const node::Taken& taken, std::chrono::nanoseconds end,
            std::chrono::nanoseconds received, node::ScanCollector& collector,
            tf2::BufferCore& transforms) const;

  const config::Parameters& parameters_;
  rosbag::Bag bag_;
  node::SensorRegistry registry_;
  node::MessageIntake intake_;       // its topics without their slashes
  std::vector<std::string> topics_;  // to be read, as the bag names them
  std::vector<geometry_msgs::TransformStamped> static_transforms_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_SCANNER_H
