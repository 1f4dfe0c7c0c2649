#include "core/recognize/peak_sharpness.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include "core/match/climber.h"

namespace place_memory::core {
namespace {

constexpr int kShifted = 2;  ///< [cells]
constexpr int kRotated = 2;  ///< [heading steps]

/// 0 of none.
double meanChange(const Alignment* begin, const Alignment* end, double from) {
  double sum = 0.0;
  for (const Alignment* at = begin; at != end; ++at) sum += at->score - from;
  return begin == end ? 0.0 : sum / static_cast<double>(end - begin);
}

}  // namespace

PeakSharpness peakSharpness(const QueryPlanes& query, const CellPlanes& learned,
                            const LatticeMetric& metric, const SearchWindow& window,
                            const Alignment& at) {
  std::array<Alignment, 6> near;
  Alignment* end = near.data();
  const auto tryShift = [&](int columns, int rows) {
    const CellShift shift{at.shift.columns + columns, at.shift.rows + rows};
    if (std::max(std::abs(shift.columns), std::abs(shift.rows)) < kGridSize)
      *end++ = {shift, at.rotation};
  };
  for (const int by : {-kShifted, kShifted}) tryShift(by, 0);
  for (const int by : {-kShifted, kShifted}) tryShift(0, by);
  Alignment* const rotated = end;
  for (const int by : {-kRotated, kRotated}) {
    const int rotation = window.wrapped(at.rotation + by);
    if (std::abs(rotation) <= window.rotations) *end++ = {at.shift, rotation};
  }
  Climber(query, learned, metric, window)
      .evaluate(near.data(), static_cast<std::size_t>(end - near.data()));
  return {meanChange(near.data(), rotated, at.score), meanChange(rotated, end, at.score)};
}

}  // namespace place_memory::core
