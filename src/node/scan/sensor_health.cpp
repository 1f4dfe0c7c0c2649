#include "node/scan/sensor_health.h"

namespace place_memory::node {

std::string inWords(const RejectCounts& rejected) {
  std::string text;
  for (std::size_t i = 0; i < kRejects; ++i) {
    if (rejected[i] == 0) continue;
    if (!text.empty()) text += ", ";
    text += std::to_string(rejected[i]) + ' ' + toString(static_cast<Reject>(i));
  }
  return text;
}

SensorHealth& SensorHealthTable::find(const std::string& frame) {
  const auto known = sensors_.find(frame);
  if (known != sensors_.end()) return known->second;
  return sensors_[sensors_.size() < kMaxSensors ? frame : kOthers];
}

void SensorHealthTable::noteMessage(const sensor_msgs::Range& message, const ros::Time& received) {
  SensorHealth& sensor = find(message.header.frame_id);
  ++sensor.messages;
  sensor.last_received = received;
  sensor.sensor_problem = checkSensor(message).value_or("");
}

void SensorHealthTable::noteReject(const std::string& frame, Reject reject) {
  ++find(frame).rejected.at(static_cast<std::size_t>(reject));
}

}  // namespace place_memory::node
