#include "place_memory/core/query_planes.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

int popcount(std::uint64_t word) { return __builtin_popcountll(word); }

std::uint64_t shifted(std::uint64_t row, int columns) {
  return columns >= 0 ? row << columns : row >> -columns;
}

}  // namespace

TurnedPlanes::TurnedPlanes(const CellPlanes& grid, double angle) {
  constexpr double kMiddle = 0.5 * (kGridSize - 1);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const double x = column - kMiddle;
      const double y = row - kMiddle;
      const long from_column = std::lround(c * x + s * y + kMiddle);
      const long from_row = std::lround(-s * x + c * y + kMiddle);
      if (from_column < 0 || from_column >= kGridSize) continue;
      if (from_row < 0 || from_row >= kGridSize) continue;
      const auto r = static_cast<std::size_t>(row);
      const auto from = static_cast<std::size_t>(from_row);
      inside[r] |= std::uint64_t{1} << column;
      cells.occupied[r] |= (grid.occupied[from] >> from_column & 1) << column;
      cells.empty[r] |= (grid.empty[from] >> from_column & 1) << column;
    }
  }
}

PairCounts countPairs(const TurnedPlanes& recognition, CellShift shift, const CellPlanes& learned) {
  int inside = 0, occupied = 0, empty = 0, on_occupied = 0, on_empty = 0;
  int occupied_occupied = 0, occupied_empty = 0, empty_occupied = 0, empty_empty = 0;
  const int first = std::max(0, shift.rows);
  const int last = std::min(kGridSize, kGridSize + shift.rows);
  for (int row = first; row < last; ++row) {
    const auto from = static_cast<std::size_t>(row - shift.rows);
    const auto to = static_cast<std::size_t>(row);
    const std::uint64_t i = shifted(recognition.inside[from], shift.columns);
    const std::uint64_t o = shifted(recognition.cells.occupied[from], shift.columns);
    const std::uint64_t e = shifted(recognition.cells.empty[from], shift.columns);
    inside += popcount(i);
    occupied += popcount(o);
    empty += popcount(e);
    on_occupied += popcount(i & learned.occupied[to]);
    on_empty += popcount(i & learned.empty[to]);
    occupied_occupied += popcount(o & learned.occupied[to]);
    occupied_empty += popcount(o & learned.empty[to]);
    empty_occupied += popcount(e & learned.occupied[to]);
    empty_empty += popcount(e & learned.empty[to]);
  }
  const int unsensed = inside - occupied - empty;
  const int unsensed_occupied = on_occupied - occupied_occupied - empty_occupied;
  const int unsensed_empty = on_empty - occupied_empty - empty_empty;
  return {{{empty_empty, empty - empty_empty - empty_occupied, empty_occupied},
           {unsensed_empty, unsensed - unsensed_empty - unsensed_occupied, unsensed_occupied},
           {occupied_empty, occupied - occupied_empty - occupied_occupied, occupied_occupied}}};
}

QueryPlanes::QueryPlanes(const EvidenceGrid& grid, double heading_step, int turns)
    : heading_step_(heading_step), turns_(turns) {
  const CellPlanes planes(grid);
  planes_.reserve(static_cast<std::size_t>(2 * turns + 1));
  for (int turn = -turns; turn <= turns; ++turn) planes_.emplace_back(planes, turn * heading_step);
}

}  // namespace place_memory::core
