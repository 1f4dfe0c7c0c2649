#ifndef PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H
#define PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H

#include <sensor_msgs/Range.h>

#include <map>
#include <string>
#include <utility>

#include "config/parameters.h"
#include "node/input/adapted_reading.h"
#include "node/input/echo_dialect.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// Takes sensor_msgs/Range: the sensor sits at the origin of its frame and looks along the x axis.
class RangeAdapter {
 public:
  /// Parameters and registry must outlive the adapter. `topic`: of the messages, as people know it.
  RangeAdapter(std::string topic, const config::Parameters& parameters, SensorRegistry& registry)
      : topic_(std::move(topic)), parameters_(&parameters), registry_(&registry) {}

  AdaptedReading adapt(const sensor_msgs::Range& message);

 private:
  std::string topic_;
  const config::Parameters* parameters_;
  SensorRegistry* registry_;
  std::map<core::SensorId, EchoDialect> dialects_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_RANGE_ADAPTER_H
