#include "place_memory/core/falloff.h"

#include <cstdlib>

namespace place_memory::core {
namespace {

constexpr int kBeside = 2;  ///< [cells]
constexpr int kTurned = 2;  ///< [heading steps]

}  // namespace

Falloff falloffAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                  const SearchWindow& window, const Alignment& at) {
  const auto fall = [&](CellShift shift, int turn) {
    return scoreAt(query, learned, metric, shift, turn) - at.score;
  };
  Falloff falloff;
  for (const int by : {-kBeside, kBeside}) {
    falloff.beside += 0.25 * fall({at.shift.columns + by, at.shift.rows}, at.turn);
    falloff.beside += 0.25 * fall({at.shift.columns, at.shift.rows + by}, at.turn);
  }
  int turns = 0;
  for (const int by : {-kTurned, kTurned}) {
    const int turn = window.wrapped(at.turn + by);
    if (std::abs(turn) > window.turns) continue;
    falloff.turned += fall(at.shift, turn);
    ++turns;
  }
  if (turns > 0) falloff.turned /= turns;
  return falloff;
}

}  // namespace place_memory::core
