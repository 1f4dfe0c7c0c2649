#include "core/grid/grid_fusion.h"

#include <algorithm>

namespace place_memory::core {

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
