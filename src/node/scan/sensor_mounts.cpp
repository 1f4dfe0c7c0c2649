#include "node/scan/sensor_mounts.h"

#include "node/input/sensor_placement.h"
#include "node/scan/reading_locator.h"

namespace place_memory::node {
namespace {

// More than any message is thinned to.
constexpr std::size_t kMostCones = 256;

}  // namespace

void SensorMounts::note(const core::Measurement& measurement, std::chrono::nanoseconds now) {
  if (!first_) first_ = now;
  Mount& mount = mounts_[measurement.sensor];
  if (mount.frame != measurement.frame || mount.stamp != measurement.stamp) mount.cones.clear();
  mount.frame = measurement.frame;
  mount.stamp = measurement.stamp;
  if (mount.cones.size() == kMostCones) return;
  mount.cones.push_back({measurement.frame_from_sensor, measurement.spec.field_of_view});
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
    for (const Cone& cone : mount.cones) {
      mounts.push_back({(frame->pose * cone.frame_from_sensor).yaw, cone.field_of_view});
    }
  }
  return mounts;
}

}  // namespace place_memory::node
