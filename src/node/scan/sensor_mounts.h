#ifndef PLACE_MEMORY_NODE_SCAN_SENSOR_MOUNTS_H
#define PLACE_MEMORY_NODE_SCAN_SENSOR_MOUNTS_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/sensing/measurement.h"
#include "core/sensing/sweep_plan.h"

namespace place_memory::node {

/// Where the sensors look that were heard.
class SensorMounts {
 public:
  /// A usable measurement came. `now` is a time that never goes back.
  void note(const core::Measurement& measurement, std::chrono::nanoseconds now);

  /// Of those sensors, as far as tf knows the way from their frames to the base's; without those
  /// that look up or down.
  std::vector<core::SensorMount> of(const std::set<core::SensorId>& sensors,
                                    const tf2::BufferCore& buffer,
                                    const std::string& base_frame) const;

  /// When the first sensor was heard.
  std::optional<std::chrono::nanoseconds> first() const { return first_; }

 private:
  struct Cone {
    core::Pose2d frame_from_sensor;
    double field_of_view = 0.0;
  };
  /// A laser's message has many cones of one sensor: those of the newest stamp stay.
  struct Mount {
    std::string frame;
    std::chrono::nanoseconds stamp{0};
    std::vector<Cone> cones;
  };

  std::map<core::SensorId, Mount> mounts_;
  std::optional<std::chrono::nanoseconds> first_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SENSOR_MOUNTS_H
