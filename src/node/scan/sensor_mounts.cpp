#include "node/scan/sensor_mounts.h"

#include "node/input/sensor_placement.h"
#include "node/scan/reading_locator.h"

namespace place_memory::node {

void SensorMounts::note(const core::Measurement& measurement, std::chrono::nanoseconds now) {
  if (!first_) first_ = now;
  Mount& mount = mounts_[measurement.sensor];
  if (mount.frame != measurement.frame) mount.frame = measurement.frame;
  mount.frame_from_sensor = measurement.frame_from_sensor;
  mount.field_of_view = measurement.spec.field_of_view;
}

std::vector<core::SensorMount> SensorMounts::of(const std::set<core::SensorId>& sensors,
                                                const tf2::BufferCore& buffer,
                                                const std::string& base_frame) const {
  std::vector<core::SensorMount> mounts;
  for (const auto& [sensor, mount] : mounts_) {
    if (sensors.count(sensor) == 0) continue;
    std::chrono::nanoseconds stamp{0};
    const auto frame = lookupNewest(buffer, base_frame, mount.frame, stamp);
    if (!frame || frame->level < ReadingLocator::kLeastLevel) continue;
    mounts.push_back({(frame->pose * mount.frame_from_sensor).yaw, mount.field_of_view});
  }
  return mounts;
}

}  // namespace place_memory::node
