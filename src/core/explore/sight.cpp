#include "core/explore/sight.h"

#include <cmath>
#include <optional>

namespace place_memory::core {
namespace {

constexpr int kRays = 120;
constexpr double kLookEvery = 0.5;  // of the way [m]

}  // namespace

std::vector<std::uint8_t> inSight(const FreeSpace& space, const std::vector<Pose2d>& trail,
                                  const SightOptions& options) {
  std::vector<std::uint8_t> seen(space.size(), 0);
  const Pose2d* last = nullptr;
  for (const Pose2d& spot : trail) {
    if (last && std::hypot(spot.x - last->x, spot.y - last->y) < kLookEvery) continue;
    last = &spot;
    for (int i = 0; i < kRays; ++i) {
      const double bearing = 2.0 * kPi * i / kRays;
      const double c = std::cos(bearing), s = std::sin(bearing);
      double unknown = 0.0;
      for (double way = 0.0; way <= options.reach; way += space.resolution()) {
        const auto cell = space.cellAt(spot.x + way * c, spot.y + way * s);
        if (!cell || space.state(*cell) == FreeSpace::State::kOccupied) break;
        if (space.state(*cell) == FreeSpace::State::kUnknown) unknown += space.resolution();
        if (unknown > options.beyond) break;
        seen[*cell] = 1;
      }
    }
  }
  return seen;
}

}  // namespace place_memory::core
