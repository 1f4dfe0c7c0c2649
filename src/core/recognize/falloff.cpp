#include "core/recognize/falloff.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include "core/match/climber.h"

namespace place_memory::core {
namespace {

constexpr int kBeside = 2;  ///< [cells]
constexpr int kTurned = 2;  ///< [heading steps]

/// 0 of none.
double meanChange(const Alignment* begin, const Alignment* end, double from) {
  double sum = 0.0;
  for (const Alignment* at = begin; at != end; ++at) sum += at->score - from;
  return begin == end ? 0.0 : sum / static_cast<double>(end - begin);
}

}  // namespace

Falloff falloffAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                  const SearchWindow& window, const Alignment& at) {
  std::array<Alignment, 6> near;
  Alignment* end = near.data();
  const auto tryShift = [&](int columns, int rows) {
    const CellShift shift{at.shift.columns + columns, at.shift.rows + rows};
    if (std::max(std::abs(shift.columns), std::abs(shift.rows)) < kGridSize)
      *end++ = {shift, at.turn};
  };
  for (const int by : {-kBeside, kBeside}) tryShift(by, 0);
  for (const int by : {-kBeside, kBeside}) tryShift(0, by);
  Alignment* const turned = end;
  for (const int by : {-kTurned, kTurned}) {
    const int turn = window.wrapped(at.turn + by);
    if (std::abs(turn) <= window.turns) *end++ = {at.shift, turn};
  }
  Climber(query, learned, metric, window)
      .evaluate(near.data(), static_cast<std::size_t>(end - near.data()));
  return {meanChange(near.data(), turned, at.score), meanChange(turned, end, at.score)};
}

}  // namespace place_memory::core
