#ifndef PLACE_MEMORY_TOOLS_BAG_SCANNER_H
#define PLACE_MEMORY_TOOLS_BAG_SCANNER_H

#include <geometry_msgs/TransformStamped.h>

#include <set>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/input/message_intake.h"
#include "node/input/sensor_registry.h"
#include "node/scan/scan_collector.h"
#include "tools/bag_set.h"

namespace place_memory::tools {

/// What came of a scan.
struct BagScan {
  node::ScanOutcome outcome;
  std::string left_out;  ///< how many readings were not used and why, in words; empty: none
};

/// Takes scans from bags with the collector that the node uses.
class BagScanner {
 public:
  /// Both must outlive the scanner. Throws std::runtime_error where the bags lack a topic or cannot
  /// be read.
  BagScanner(const BagSet& bags, const config::Parameters& parameters);

  /// Every usable reading between two times, by its stamp. Throws std::exception where a bag is
  /// damaged there.
  BagScan scan(const ros::Time& start, const ros::Time& end);

  /// What a message says, be it of a scan or of a drive. `transforms`: in which the frame of a
  /// compass is looked up.
  node::Taken take(const TimedMessage& timed, const tf2::BufferCore& transforms);

  /// To be read, tf among them; without slashes.
  const std::set<std::string>& topics() const { return topics_; }
  const std::vector<geometry_msgs::TransformStamped>& staticTransforms() const {
    return static_transforms_;
  }

 private:
  /// The types of a topic. Throws std::runtime_error where the bags lack it.
  const std::set<std::string>& require(const std::string& topic) const;
  void readStaticTransforms();

  const BagSet& bags_;
  const config::Parameters& parameters_;
  // What they find out of the sensors in one scan holds for those after it.
  node::SensorRegistry registry_;
  node::MessageIntake intake_;
  std::set<std::string> topics_;  // to be read, without their slashes
  std::vector<geometry_msgs::TransformStamped> static_transforms_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_SCANNER_H
