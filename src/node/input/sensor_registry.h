#ifndef PLACE_MEMORY_NODE_INPUT_SENSOR_REGISTRY_H
#define PLACE_MEMORY_NODE_INPUT_SENSOR_REGISTRY_H

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/sensing/measurement.h"

namespace place_memory::node {

/// Sensors beyond SensorRegistry::kMaxSensors share this number.
constexpr core::SensorId kOtherSensors = 0;

/// Knows the sensors by the topic and the frame of their messages, and gives each a number. It is
/// bounded, so that messages with ever new frames take no memory.
class SensorRegistry {
 public:
  static constexpr std::size_t kMaxSensors = 256;

  /// The same number for the same names. `index`: of the sensor where a message is of a whole ring
  /// of them; -1: it is not.
  core::SensorId idOf(const std::string& topic, const std::string& frame, int index = -1);

  const std::string& topicOf(core::SensorId sensor) const { return sensors_.at(sensor).topic; }
  const std::string& frameOf(core::SensorId sensor) const { return sensors_.at(sensor).frame; }
  /// One of a ring whose message has a frame for all of them.
  bool isOfRing(core::SensorId sensor) const { return sensors_.at(sensor).index >= 0; }
  /// For people: its index if it has one; else its frame, and the topic too where sensors on
  /// several topics have that frame.
  std::string nameOf(core::SensorId sensor) const;

 private:
  struct Sensor {
    std::string topic;
    std::string frame;
    int index = -1;
  };

  std::vector<Sensor> sensors_ = {{"other topics", "(other frames)", -1}};  // by their number
  std::map<std::tuple<std::string, std::string, int>, core::SensorId> numbers_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_SENSOR_REGISTRY_H
