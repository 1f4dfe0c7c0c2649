#include "core/recognize/rescoring.h"

#include <algorithm>
#include <cmath>

#include "core/kernels/pair_kernel.h"

namespace place_memory::core {
namespace {

constexpr double kInnerRadius = 9.0;    ///< [cells]
constexpr double kMiddleRadius = 17.0;  ///< [cells]

/// Cells whose centres are more than `from` and up to `to` cells from the place.
BitPlane ring(double from, double to) {
  constexpr double kMiddle = 0.5 * (kGridSize - 1);
  BitPlane cells{};
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const double distance = std::hypot(column - kMiddle, row - kMiddle);
      if (distance <= from || distance > to) continue;
      cells[static_cast<std::size_t>(row)] |= std::uint64_t{1} << column;
    }
  }
  return cells;
}

BitPlane shifted(const BitPlane& plane, CellShift shift) {
  BitPlane moved{};
  const int first = std::max(0, shift.rows);
  const int last = std::min(kGridSize, kGridSize + shift.rows);
  for (int row = first; row < last; ++row) {
    const std::uint64_t from = plane[static_cast<std::size_t>(row - shift.rows)];
    moved[static_cast<std::size_t>(row)] =
        shift.columns >= 0 ? from << shift.columns : from >> -shift.columns;
  }
  return moved;
}

/// With the eight neighbours of every cell.
BitPlane widened(const BitPlane& plane) {
  BitPlane wide{};
  for (std::size_t row = 0; row < kGridSize; ++row) {
    std::uint64_t column = plane[row];
    if (row > 0) column |= plane[row - 1];
    if (row + 1 < kGridSize) column |= plane[row + 1];
    wide[row] = column | column << 1 | column >> 1;
  }
  return wide;
}

PlaneCounts countCells(const BitPlane& a, const BitPlane& b, const BitPlane& c, const BitPlane& d) {
  return countPlanes({a.data(), b.data(), c.data(), d.data(), kGridSize, 0});
}

CellPlanes inside(const BitPlane& region, CellPlanes cells) {
  for (std::size_t row = 0; row < kGridSize; ++row) {
    cells.occupied[row] &= region[row];
    cells.empty[row] &= region[row];
  }
  return cells;
}

PairCounts pairsInside(const BitPlane& region, const CellPlanes& scan, const CellPlanes& learned) {
  constexpr auto kUnsensed = static_cast<std::size_t>(CellClass::kUnsensed);
  PairCounts counts = countPairs(inside(region, scan), {0, 0}, inside(region, learned));
  const auto cells = static_cast<int>(countCells(region, region, region, region).occupied);
  counts[kUnsensed][kUnsensed] -= kGridCells - cells;
  return counts;
}

}  // namespace

RescoringCounts countForRescoring(const CellPlanes& recognition, CellShift shift,
                                  const CellPlanes& learned) {
  static const BitPlane kInner = ring(-1.0, kInnerRadius);
  static const BitPlane kMiddle = ring(kInnerRadius, kMiddleRadius);
  CellPlanes scan;
  scan.occupied = shifted(recognition.occupied, shift);
  scan.empty = shifted(recognition.empty, shift);
  const BitPlane scan_one = widened(scan.occupied), scan_two = widened(scan_one);
  const BitPlane learned_one = widened(learned.occupied), learned_two = widened(learned_one);
  RescoringCounts counts;
  counts.inner = pairsInside(kInner, scan, learned);
  counts.middle = pairsInside(kMiddle, scan, learned);
  const PlaneCounts by_learned = countCells(scan.occupied, scan.empty, learned_one, learned_two);
  const PlaneCounts by_scan = countCells(scan_one, scan_two, learned.occupied, learned.empty);
  const PlaneCounts by_both = countCells(scan_one, scan_one, learned_one, learned_one);
  const auto count = [](std::uint64_t cells) { return static_cast<int>(cells); };
  counts.near = {count(by_learned.occupied_occupied), count(by_learned.occupied_empty),
                 count(by_scan.occupied_occupied),    count(by_scan.empty_occupied),
                 count(by_both.occupied_occupied),    count(by_learned.empty_occupied),
                 count(by_scan.occupied_empty)};
  return counts;
}

double rescore(double search_score, const RescoringCounts& counts, const PeakSharpness& sharpness,
               const RescoringWeights& weights) {
  double score = weights.search_score * search_score + pairScore(counts.inner, weights.inner) +
                 pairScore(counts.middle, weights.middle) +
                 weights.peak_sharpness_shift * sharpness.shift +
                 weights.peak_sharpness_rotation * sharpness.rotation;
  for (std::size_t i = 0; i < kNearPairs; ++i) score += counts.near[i] * weights.near[i];
  return score;
}

std::vector<double> combineScores(const std::vector<double>& search,
                                  const std::vector<double>& rescored) {
  std::vector<double> scores = rescored;
  const double last = search[rescored.size() - 1];
  const double least = *std::min_element(rescored.begin(), rescored.end());
  for (std::size_t i = rescored.size(); i < search.size(); ++i) {
    scores.push_back(least + search[i] - last);
  }
  return scores;
}

}  // namespace place_memory::core
