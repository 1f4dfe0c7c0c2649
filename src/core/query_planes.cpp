#include "place_memory/core/query_planes.h"

#include <algorithm>
#include <cmath>

#include "pair_kernel.h"

namespace place_memory::core {
namespace {

int countCells(const BitPlane& plane) {
  int cells = 0;
  for (const std::uint64_t row : plane) cells += __builtin_popcountll(row);
  return cells;
}

}  // namespace

CellPlanes turned(const CellPlanes& grid, double angle) {
  CellPlanes cells;
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
      cells.occupied[r] |= (grid.occupied[from] >> from_column & 1) << column;
      cells.empty[r] |= (grid.empty[from] >> from_column & 1) << column;
    }
  }
  return cells;
}

PairCounts countPairs(const CellPlanes& recognition, CellShift shift, const CellPlanes& learned) {
  const int first = std::max(0, shift.rows);
  const int last = std::min(kGridSize, kGridSize + shift.rows);
  const int from = first - shift.rows;
  const PlaneCounts n = countPlanes(
      {recognition.occupied.data() + from, recognition.empty.data() + from,
       learned.occupied.data() + first, learned.empty.data() + first, last - first, shift.columns});
  const auto count = [](std::uint64_t cells) { return static_cast<int>(cells); };
  const int oo = count(n.occupied_occupied), oe = count(n.occupied_empty);
  const int eo = count(n.empty_occupied), ee = count(n.empty_empty);
  const int ou = count(n.occupied) - oo - oe, eu = count(n.empty) - eo - ee;
  const int uo = countCells(learned.occupied) - oo - eo, ue = countCells(learned.empty) - oe - ee;
  const int uu = kGridSize * kGridSize - oo - oe - ou - eo - ee - eu - uo - ue;
  return {{{ee, eu, eo}, {ue, uu, uo}, {oe, ou, oo}}};
}

QueryPlanes::QueryPlanes(const EvidenceGrid& grid, double heading_step, int turns)
    : heading_step_(heading_step), turns_(turns) {
  const CellPlanes planes(grid);
  planes_.reserve(static_cast<std::size_t>(2 * turns + 1));
  for (int turn = -turns; turn <= turns; ++turn) {
    planes_.push_back(turned(planes, turn * heading_step));
  }
}

}  // namespace place_memory::core
