#include "core/match/alignment_search.h"

#include <array>

#include "core/kernels/coarse_planes.h"
#include "core/match/restarts.h"

namespace place_memory::core {
namespace {

Alignment exhaustive(const Climber& climber, const SearchWindow& window) {
  Alignment best = climber.evaluate({0, 0}, 0);
  const int last_rotation = window.circular ? window.rotations - 1 : window.rotations;
  for (int rotation = -window.rotations; rotation <= last_rotation; ++rotation) {
    for (int rows = -window.cells; rows <= window.cells; ++rows) {
      for (int columns = -window.cells; columns <= window.cells; ++columns) {
        const Alignment found = climber.evaluate({columns, rows}, rotation);
        if (found.score > best.score) best = found;
      }
    }
  }
  return best;
}

Alignment restarts(Climber& climber, const QueryPlanes& query, const CellPlanes& learned,
                   const LatticeMetric& metric, const SearchWindow& window) {
  support::WorkerPool alone(1);
  const SeedGrid grid(query, FixedMetric(metric), window, kSeeding, alone);
  std::array<QueryRow, kCoarsestRows> rows;
  coarsenMost(learned, rows.data());
  CoarsestBlock places{};
  for (std::size_t row = 0; row < kCoarsestRows; ++row) {
    places[row].occupied[0] = rows[row].occupied;
    places[row].empty[0] = rows[row].empty;
  }
  SeedScores scores;
  grid.score(places, scores);
  return refine(climber, climbFromSeeds(climber, chooseSeeds(climber, grid, scores, 0)));
}

}  // namespace

double scoreAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int rotation) {
  const SearchWindow anywhere;
  return Climber(query, learned, metric, anywhere).evaluate(shift, rotation).score;
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
