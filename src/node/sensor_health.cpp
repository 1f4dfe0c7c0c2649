#include "place_memory/node/sensor_health.h"

namespace place_memory::node {

SensorHealth& SensorHealthTable::find(const std::string& frame) {
  const auto known = sensors_.find(frame);
  if (known != sensors_.end()) return known->second;
  return sensors_[sensors_.size() < kMaxSensors ? frame : kOthers];
}

void SensorHealthTable::noteMessage(const sensor_msgs::Range& message) {
  SensorHealth& sensor = find(message.header.frame_id);
  ++sensor.messages;
  sensor.last_stamp = message.header.stamp;
  sensor.sensor_problem = checkSensor(message).value_or("");
}

void SensorHealthTable::noteReject(const std::string& frame, Reject reject) {
  ++find(frame).rejected.at(static_cast<std::size_t>(reject));
}

}  // namespace place_memory::node
