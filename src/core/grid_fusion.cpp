#include "place_memory/core/grid_fusion.h"

#include <algorithm>

namespace place_memory::core {

std::vector<SonarReading> movedReadings(const std::vector<SonarReading>& readings,
                                        const Pose2d& target_from_readings) {
  std::vector<SonarReading> moved = readings;
  for (SonarReading& reading : moved) {
    reading.sensor_pose = target_from_readings * reading.sensor_pose;
  }
  return moved;
}

void fuse(const EvidenceGrid& scan, double retention, EvidenceGrid& learned) {
  constexpr int kLimit = EvidenceGrid::kLimit;
  for (std::size_t i = 0; i < scan.cells().size(); ++i) {
    const std::int8_t sensed = scan.cells()[i];
    if (sensed == 0) continue;
    // Towards zero, so that what is not seen again is gone some day.
    const int kept = static_cast<int>(retention * learned.cells()[i]);
    learned.cells()[i] = static_cast<std::int8_t>(std::clamp(kept + sensed, -kLimit, kLimit));
  }
}

}  // namespace place_memory::core
