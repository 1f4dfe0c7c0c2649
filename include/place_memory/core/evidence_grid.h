#ifndef PLACE_MEMORY_CORE_EVIDENCE_GRID_H
#define PLACE_MEMORY_CORE_EVIDENCE_GRID_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "place_memory/core/grid_geometry.h"

namespace place_memory::core {

/// Evidence for occupancy in 64 x 64 cells: one byte a cell, on a logarithmic scale (paper 3.1.2).
///
/// A cell holds log(odds / prior odds) in steps of 1 / kStepsPerNat, so that 0 is the prior, an
/// update is one addition, and a grid means the same whatever the prior.
class EvidenceGrid {
 public:
  static constexpr int kStepsPerNat = 16;
  static constexpr int kLimit = 127;  ///< cells saturate at +-kLimit: about +-7.9 nats

  EvidenceGrid() = default;
  explicit EvidenceGrid(GridGeometry geometry) : geometry_(geometry) {}

  const GridGeometry& geometry() const { return geometry_; }

  /// Evidence of a cell, in [-kLimit, kLimit]; row and column in [0, 63].
  std::int8_t at(int row, int column) const { return cells_[offset(row, column)]; }

  /// Adds evidence to a cell, saturating; row and column in [0, 63].
  void add(int row, int column, int evidence) {
    std::int8_t& cell = cells_[offset(row, column)];
    cell = static_cast<std::int8_t>(std::clamp(cell + evidence, -kLimit, kLimit));
  }

  /// Row by row, row 0 (least y) first.
  const std::array<std::int8_t, kGridCells>& cells() const { return cells_; }
  std::array<std::int8_t, kGridCells>& cells() { return cells_; }

  bool operator==(const EvidenceGrid& other) const {
    return geometry_.cell_size == other.geometry_.cell_size && cells_ == other.cells_;
  }

  /// Probability that a cell with this evidence is occupied, where the prior probability is `prior`
  /// in (0, 1).
  static double probability(int evidence, double prior) {
    const double log_odds =
        std::log(prior / (1.0 - prior)) + static_cast<double>(evidence) / kStepsPerNat;
    return 1.0 / (1.0 + std::exp(-log_odds));
  }

 private:
  static std::size_t offset(int row, int column) {
    return static_cast<std::size_t>(row) * kGridSize + static_cast<std::size_t>(column);
  }

  GridGeometry geometry_;
  std::array<std::int8_t, kGridCells> cells_{};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EVIDENCE_GRID_H
