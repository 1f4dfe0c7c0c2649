#include "core/sensing/scan_echoes.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {

std::uint32_t countEchoes(const std::vector<SonarReading>& readings, const GridGeometry& geometry) {
  const auto lies_within = [&geometry](const SonarReading& reading) {
    if (!std::isfinite(reading.range)) return false;
    const Pose2d spot = reading.sensor_pose * Pose2d{reading.range, 0.0, 0.0};
    return std::max(std::abs(spot.x), std::abs(spot.y)) < geometry.halfWidth();
  };
  return static_cast<std::uint32_t>(std::count_if(readings.begin(), readings.end(), lies_within));
}

bool holdsEcho(const Scan& scan) {
  const auto& cells = scan.grid.cells();
  const bool occupied =
      std::any_of(cells.begin(), cells.end(), [](std::int8_t evidence) { return evidence > 0; });
  return occupied &&
         (scan.readings.empty() || countEchoes(scan.readings, scan.grid.geometry()) > 0);
}

}  // namespace place_memory::core
