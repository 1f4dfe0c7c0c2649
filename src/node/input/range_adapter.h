#ifndef PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H
#define PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H

#include <sensor_msgs/Range.h>

#include <string>
#include <utility>

#include "node/input/adapted_reading.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// Takes sensor_msgs/Range: the sensor sits at the origin of its frame and looks along the x axis.
class RangeAdapter {
 public:
  /// The registry must outlive the adapter. `topic`: of the messages, as people know it;
  /// `over_range_is_no_echo`: as checkRange() has it.
  RangeAdapter(std::string topic, bool over_range_is_no_echo, SensorRegistry& registry)
      : topic_(std::move(topic)),
        over_range_is_no_echo_(over_range_is_no_echo),
        registry_(&registry) {}

  AdaptedReading adapt(const sensor_msgs::Range& message) const;

 private:
  std::string topic_;
  bool over_range_is_no_echo_;
  SensorRegistry* registry_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H
