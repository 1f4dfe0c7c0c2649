#ifndef PLACE_MEMORY_NODE_INPUT_CLOUD_ADAPTER_H
#define PLACE_MEMORY_NODE_INPUT_CLOUD_ADAPTER_H

#include <std_msgs/Header.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/parameters.h"
#include "node/input/adapted_reading.h"
#include "node/input/cloud_points.h"
#include "node/input/ray_fit.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// Takes sensor_msgs/PointCloud and PointCloud2 of a ring of sonars, a point for each sensor in
/// their order (RosAria). A point at the origin or from the sensors' max_range on is no echo.
class CloudAdapter {
 public:
  /// Parameters and registry must outlive the adapter. `topic`: of the messages, as people know it.
  CloudAdapter(std::string topic, const config::Parameters& parameters, SensorRegistry& registry)
      : topic_(std::move(topic)), parameters_(&parameters), registry_(&registry) {}

  template <class Cloud>
  std::vector<AdaptedReading> adapt(const Cloud& cloud) {
    return adapt(cloud.header, pointsOf(cloud));
  }

 private:
  std::vector<AdaptedReading> adapt(const std_msgs::Header& header, const CloudPoints& points);
  /// Of sensor `index`; nothing: not known yet.
  std::optional<core::Pose2d> mountOf(std::size_t index, const CloudPoint& point);
  void measure(std::size_t index, const CloudPoint& point, AdaptedReading& reading);

  std::string topic_;
  const config::Parameters* parameters_;
  SensorRegistry* registry_;
  std::vector<RayFit> rays_;  // by sensor
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_CLOUD_ADAPTER_H
