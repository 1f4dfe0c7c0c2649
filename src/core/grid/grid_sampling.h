#ifndef PLACE_MEMORY_CORE_GRID_GRID_SAMPLING_H
#define PLACE_MEMORY_CORE_GRID_GRID_SAMPLING_H

#include <array>
#include <cstdint>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Side of a tile of a lattice [cells].
constexpr int kTileSize = 64;
constexpr int kTileCells = kTileSize * kTileSize;

/// Evidence of a tile's cells, row by row, least y first.
using TileEvidence = std::array<std::int8_t, kTileCells>;

/// A grid that lies somewhere, as the cells of another lattice have it. Between the centres of its
/// cells evidence runs straight; where a cell of the lattice is larger than one of the grid's, an
/// obstacle anywhere in it is one of the whole cell.
///
/// Cell (0, 0) of the lattice has its lower left corner at the frame's origin; tile (0, 0) too.
class GridSampling {
 public:
  /// `pose`: of the grid in the lattice's frame; `resolution`: side of the lattice's cells [m].
  GridSampling(const EvidenceGrid& grid, const Pose2d& pose, double resolution);

  /// False where the grid says nothing of that tile; it is all 0 then.
  bool sample(std::int64_t tile_column, std::int64_t tile_row, TileEvidence& evidence) const;

  /// Tiles that the grid can say something of lie from first to last, in columns and in rows.
  struct TileSpan {
    std::int64_t first_column, last_column, first_row, last_row;
  };
  TileSpan span() const;

 private:
  static constexpr int kPadded = kGridSize + 2;

  /// In cells of the padded grid, from the centre of its first one.
  struct Spot {
    double u, v;
  };
  Spot spotOf(double x, double y) const;
  double at(const Spot& spot) const;
  double inCell(double x, double y) const;
  void sampleRow(double x, double y, std::int8_t* evidence) const;

  std::array<std::int8_t, kPadded * kPadded> cells_{};  ///< with unsensed ones around them
  Pose2d pose_;
  double cosine_, sine_;
  double cell_size_;
  double resolution_;
  int samples_;  ///< along each side of a cell
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_GRID_SAMPLING_H
