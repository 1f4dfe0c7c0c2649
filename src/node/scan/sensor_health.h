#ifndef PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H
#define PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H

#include <ros/time.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "node/input/range_check.h"

namespace place_memory::node {

using RejectCounts = std::array<std::uint32_t, kRejects>;

/// The counts that are not 0, e.g. "2 no stamp, 1 no heading"; empty where all are.
std::string inWords(const RejectCounts& rejected);

/// What came of one sensor's messages since the node started.
struct SensorHealth {
  std::uint64_t messages = 0;
  RejectCounts rejected{};
  ros::Time last_received;
  std::string sensor_problem;  ///< what is wrong with its limits; empty: nothing
};

/// Health of the sensors by frame_id. Frames beyond kMaxSensors share one entry, so that messages
/// with ever new frames take no memory.
class SensorHealthTable {
 public:
  static constexpr std::size_t kMaxSensors = 256;
  static constexpr char kOthers[] = "(other frames)";

  void noteMessage(const sensor_msgs::Range& message, const ros::Time& received);
  void noteReject(const std::string& frame, Reject reject);

  const std::map<std::string, SensorHealth>& sensors() const { return sensors_; }

 private:
  SensorHealth& find(const std::string& frame);

  std::map<std::string, SensorHealth> sensors_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H
