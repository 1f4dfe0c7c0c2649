#include "core/match/alignment_search.h"

#include <array>

#include "core/kernels/coarse_planes.h"
#include "core/match/restarts.h"

namespace place_memory::core {
namespace {

Alignment exhaustive(const Climber& climber, const SearchWindow& window) {
  Alignment best = climber.evaluate({0, 0}, 0);
  const int last_turn = window.circular ? window.turns - 1 : window.turns;
  for (int turn = -window.turns; turn <= last_turn; ++turn) {
    for (int rows = -window.cells; rows <= window.cells; ++rows) {
      for (int columns = -window.cells; columns <= window.cells; ++columns) {
        const Alignment found = climber.evaluate({columns, rows}, turn);
        if (found.score > best.score) best = found;
      }
    }
  }
  return best;
}

Alignment restarts(Climber& climber, const QueryPlanes& query, const CellPlanes& learned,
                   const LatticeMetric& metric, const SearchWindow& window) {
  support::WorkerPool alone(1);
  const StartLattice lattice(query, FixedMetric(metric), window, kCloseLook, alone);
  std::array<QueryRow, kCoarsestRows> rows;
  coarsenMost(learned, rows.data());
  CoarsestBlock places{};
  for (std::size_t row = 0; row < kCoarsestRows; ++row) {
    places[row].occupied[0] = rows[row].occupied;
    places[row].empty[0] = rows[row].empty;
  }
  LookScores scores;
  lattice.look(places, scores);
  return settle(climber, climbFromStarts(climber, chooseStarts(climber, lattice, scores, 0)));
}

}  // namespace

double scoreAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int turn) {
  const SearchWindow anywhere;
  return Climber(query, learned, metric, anywhere).evaluate(shift, turn).score;
}

Alignment findAlignment(const QueryPlanes& query, const CellPlanes& learned,
                        const LatticeMetric& metric, const SearchWindow& window,
                        SearchMethod method) {
  Climber climber(query, learned, metric, window);
  switch (method) {
    case SearchMethod::kNearestNeighbour:
      return climber.evaluate({0, 0}, 0);
    case SearchMethod::kHillClimbing:
      climbOnce(climber);
      return climber.summits().front();
    case SearchMethod::kRestarts:
      return restarts(climber, query, learned, metric, window);
    case SearchMethod::kExhaustive:
      return exhaustive(climber, window);
  }
  return {};
}

}  // namespace place_memory::core
