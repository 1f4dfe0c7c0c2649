#ifndef PLACE_MEMORY_TEST_CORE_RANDOM_SCAN_H
#define PLACE_MEMORY_TEST_CORE_RANDOM_SCAN_H

#include <random>

#include "place_memory/core/scan.h"

namespace place_memory::core {

/// A scan of empty space with walls at random; another seed makes another place.
inline Scan makeRandomScan(unsigned seed, double cell_size = kDefaultCellSize) {
  std::mt19937 random(seed);
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  Scan scan;
  scan.grid = EvidenceGrid(GridGeometry{cell_size});
  for (int row = 8; row < 56; ++row) {
    for (int column = 8; column < 56; ++column) scan.grid.add(row, column, -20);
  }
  for (int wall = 0; wall < 12; ++wall) {
    const bool along_x = below(2) == 0;
    const int row = 8 + below(32);
    const int column = 8 + below(32);
    for (int i = 0; i < 16; ++i) {
      scan.grid.add(along_x ? row : row + i, along_x ? column + i : column, 70);
    }
  }
  scan.odom_from_scan = {below(1000) * 0.1, below(1000) * 0.1, below(60) * 0.1 - 3.0};
  scan.end = std::chrono::seconds(1000 + seed);
  return scan;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_RANDOM_SCAN_H
