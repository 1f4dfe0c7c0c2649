#include "node/go/echo_listener.h"

#include <algorithm>

#include "node/input/sensor_placement.h"
#include "node/scan/reading_locator.h"

namespace place_memory::node {

void EchoListener::take(const Taken& taken) {
  if (listeners_ <= 0) return;
  for (const AdaptedReading& reading : taken.readings) {
    if (reading.reject) continue;
    const core::Measurement& heard = reading.measurement;
    std::chrono::nanoseconds stamp{0};  // of the mount, which hardly moves: the newest will do
    const auto mount = lookupNewest(buffer_, base_frame_, heard.frame, stamp);
    if (!mount || mount->level < ReadingLocator::kLeastLevel) continue;
    core::Pose2d frame_from_sensor = heard.frame_from_sensor;
    if (mount->upside_down) {
      frame_from_sensor = {frame_from_sensor.x, -frame_from_sensor.y, -frame_from_sensor.yaw};
    }
    // Too close to be measured is as close as can be.
    const double range = std::max(heard.range, 0.0) * mount->level;
    const std::lock_guard<std::mutex> lock(mutex_);
    ring_.hear(heard.sensor, heard.stamp, mount->pose * frame_from_sensor, range);
  }
}

core::EchoRing EchoListener::ring() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ring_;
}

}  // namespace place_memory::node
