#include "place_memory/core/query_planes.h"

#include <algorithm>
#include <cmath>

#include "pair_kernel.h"

namespace place_memory::core {
namespace {

int asInt(std::uint64_t cells) { return static_cast<int>(cells); }

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
  return PairCounter(learned).count(recognition, shift);
}

PairCounter::PairCounter(const CellPlanes& learned) : learned_(learned) {
  const std::uint64_t* o = learned.occupied.data();
  const std::uint64_t* e = learned.empty.data();
  const PlaneCounts n = countPlanes({o, e, o, e, kGridSize, 0});
  occupied_ = asInt(n.occupied);
  empty_ = asInt(n.empty);
}

PairCounts PairCounter::count(const CellPlanes& recognition, CellShift shift) const {
  const int first = std::max(0, shift.rows);
  const int last = std::min(kGridSize, kGridSize + shift.rows);
  const int from = first - shift.rows;
  const PlaneCounts n =
      countPlanes({recognition.occupied.data() + from, recognition.empty.data() + from,
                   learned_.occupied.data() + first, learned_.empty.data() + first, last - first,
                   shift.columns});
  const int oo = asInt(n.occupied_occupied), oe = asInt(n.occupied_empty);
  const int eo = asInt(n.empty_occupied), ee = asInt(n.empty_empty);
  const int ou = asInt(n.occupied) - oo - oe, eu = asInt(n.empty) - eo - ee;
  const int uo = occupied_ - oo - eo, ue = empty_ - oe - ee;
  const int uu = kGridCells - oo - oe - ou - eo - ee - eu - uo - ue;
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
