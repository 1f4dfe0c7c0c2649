#include "core/match/lattice.h"

#include <algorithm>
#include <cmath>

#include "place_memory/core/grid_geometry.h"

namespace place_memory::core {

SearchWindow searchWindow(double position_window, double heading_window, double cell_size) {
  // Windows that are whole numbers of steps must not gain one by rounding.
  constexpr double kSlack = 1e-6;
  SearchWindow window;
  const double cells = std::ceil(position_window / cell_size - kSlack);
  window.cells = static_cast<int>(std::min(cells, kGridSize - 1.0));
  window.rotations = static_cast<int>(std::ceil(heading_window / kHeadingStep - kSlack));
  window.circular = window.rotations >= kHalfCircle;
  if (window.circular) window.rotations = kHalfCircle;
  return window;
}

LatticeMetric onLattice(const MatchMetric& metric, const SearchWindow& window, double cell_size) {
  LatticeMetric lattice;
  lattice.weights = metric.weights;
  lattice.overlap_only = metric.overlap_only;
  lattice.shift_cost = metric.shift_cost * cell_size * cell_size;
  if (!window.circular && window.rotations > 0) {
    lattice.rotation_cost = metric.rotation_cost / (window.rotations * window.rotations);
  }
  return lattice;
}

}  // namespace place_memory::core
