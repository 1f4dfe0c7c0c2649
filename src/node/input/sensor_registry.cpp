#include "node/input/sensor_registry.h"

#include <algorithm>

namespace place_memory::node {

core::SensorId SensorRegistry::idOf(const std::string& topic, const std::string& frame, int index) {
  const auto known = numbers_.find({topic, frame, index});
  if (known != numbers_.end()) return known->second;
  if (numbers_.size() >= kMaxSensors) return kOtherSensors;
  const auto id = static_cast<core::SensorId>(sensors_.size());
  sensors_.push_back({topic, frame, index});
  numbers_[{topic, frame, index}] = id;
  return id;
}

std::string SensorRegistry::nameOf(core::SensorId sensor) const {
  const std::string& frame = frameOf(sensor);
  const std::string& topic = topicOf(sensor);
  const int index = sensors_.at(sensor).index;
  if (index >= 0) return "sonar " + std::to_string(index) + " of " + topic;
  if (frame.empty()) return "a sensor without a frame on " + topic;
  const auto same = std::count_if(sensors_.begin(), sensors_.end(),
                                  [&](const Sensor& other) { return other.frame == frame; });
  return same > 1 ? frame + " on " + topic : frame;
}

}  // namespace place_memory::node
