#include "core/match/query_planes.h"

#include <algorithm>

#include "core/kernels/pair_kernel.h"
#include "core/kernels/rotation_table.h"
#include "core/match/lattice.h"

namespace place_memory::core {
namespace {

EvidenceGrid occupiedThroughout() {
  EvidenceGrid grid;
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) grid.add(row, column, 1);
  }
  return grid;
}

}  // namespace

CellPlanes rotated(const CellPlanes& grid, double angle) {
  return RotationTable(angle).rotate(CellBytes(grid));
}

PairCounts countPairs(const CellPlanes& recognition, CellShift shift, const CellPlanes& learned) {
  const int first = std::max(0, shift.rows);
  const int last = std::min(kGridSize, kGridSize + shift.rows);
  const int from = first - shift.rows;
  const std::uint64_t* learned_o = learned.occupied.data();
  const std::uint64_t* learned_e = learned.empty.data();
  const PlaneCounts n =
      countPlanes({recognition.occupied.data() + from, recognition.empty.data() + from,
                   learned_o + first, learned_e + first, last - first, shift.columns});
  const PlaneCounts all = countPlanes({learned_o, learned_e, learned_o, learned_e, kGridSize, 0});
  const auto count = [](std::uint64_t cells) { return static_cast<int>(cells); };
  const int oo = count(n.occupied_occupied), oe = count(n.occupied_empty);
  const int eo = count(n.empty_occupied), ee = count(n.empty_empty);
  const int ou = count(n.occupied) - oo - oe, eu = count(n.empty) - eo - ee;
  const int uo = count(all.occupied) - oo - eo, ue = count(all.empty) - oe - ee;
  const int uu = kGridCells - oo - oe - ou - eo - ee - eu - uo - ue;
  return {{{ee, eu, eo}, {ue, uu, uo}, {oe, ou, oo}}};
}

PairCounts countOverlap(const CellPlanes& recognition, const BitPlane& reach, CellShift shift,
                        const CellPlanes& learned) {
  constexpr auto kEmpty = static_cast<std::size_t>(CellClass::kEmpty);
  constexpr auto kUnsensed = static_cast<std::size_t>(CellClass::kUnsensed);
  constexpr auto kOccupied = static_cast<std::size_t>(CellClass::kOccupied);
  CellPlanes covered;
  covered.occupied = reach;
  const PairCounts of_covered = countPairs(covered, shift, learned);
  PairCounts counts = countPairs(recognition, shift, learned);
  for (std::size_t l = 0; l < kCellClasses; ++l) {
    counts[kUnsensed][l] = of_covered[kOccupied][l] - counts[kEmpty][l] - counts[kOccupied][l];
  }
  return counts;
}

QueryPlanes::QueryPlanes(const EvidenceGrid& grid, double heading_step, int rotations)
    : heading_step_(heading_step), rotations_(rotations) {
  if (heading_step == kHeadingStep && rotations <= kHalfCircle) {
    planes_ = rotatedBySteps(grid, rotations);
    return;
  }
  const CellBytes cells(grid);
  for (int rotation = -rotations; rotation <= rotations; ++rotation) {
    planes_.push_back(RotationTable(rotation * heading_step).rotate(cells));
  }
}

BitPlane QueryPlanes::reach(int rotation) const {
  if (heading_step_ != kHeadingStep || rotations_ > kHalfCircle) {
    return rotated(CellPlanes(occupiedThroughout()), rotation * heading_step_).occupied;
  }
  static const std::vector<CellPlanes> kBySteps = rotatedBySteps(occupiedThroughout(), kHalfCircle);
  const int index = rotation + kHalfCircle;
  return kBySteps[static_cast<std::size_t>(index)].occupied;
}

}  // namespace place_memory::core
