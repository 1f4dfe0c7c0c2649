#ifndef PLACE_MEMORY_NODE_INPUT_LASER_ADAPTER_H
#define PLACE_MEMORY_NODE_INPUT_LASER_ADAPTER_H

#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/parameters.h"
#include "node/input/adapted_reading.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// Takes sensor_msgs/LaserScan as a fan of laser/cones cones (paper 6: the sensor it plans), each
/// of which hears the nearest of its beams. The whole fan is one sensor.
class LaserAdapter {
 public:
  /// Parameters and registry must outlive the adapter. `topic`: of the messages, as people know it.
  LaserAdapter(std::string topic, const config::Parameters& parameters, SensorRegistry& registry)
      : topic_(std::move(topic)), parameters_(&parameters), registry_(&registry) {}

  std::vector<AdaptedReading> adapt(const sensor_msgs::LaserScan& scan) const;

 private:
  /// Of the beams [first, last).
  void measure(const sensor_msgs::LaserScan& scan, std::size_t first, std::size_t last,
               AdaptedReading& reading) const;

  std::string topic_;
  const config::Parameters* parameters_;
  SensorRegistry* registry_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_LASER_ADAPTER_H
