#include "place_memory/core/alignment_search.h"

#include <array>
#include <cstdlib>

namespace place_memory::core {
namespace {

/// First step of a climb; halved at each local maximum until it would fall below one (paper 4).
constexpr int kFirstStep = 4;
/// Climbs start this many turns apart, and this many cells.
constexpr int kRestartTurns = 5;
constexpr int kRestartCells = 5;

class Search {
 public:
  Search(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
         const SearchWindow& window)
      : query_(query), learned_(learned), metric_(metric), window_(window) {}

  Alignment evaluate(CellShift shift, int turn) const {
    return {shift, turn, scoreAt(query_, learned_, metric_, shift, turn)};
  }

  Alignment climb(Alignment best) const {
    for (int step = kFirstStep; step >= 1; step /= 2) {
      while (stepUp(step, best)) {
      }
    }
    return best;
  }

  Alignment restarts() const {
    Alignment best = climb(evaluate({0, 0}, 0));
    const int last_turn = window_.circular ? window_.turns - 1 : window_.turns;
    const int most_cells = window_.cells - window_.cells % kRestartCells;
    const int most_turns = last_turn - last_turn % kRestartTurns;
    for (int turn = -most_turns; turn <= most_turns; turn += kRestartTurns) {
      for (int rows = -most_cells; rows <= most_cells; rows += kRestartCells) {
        for (int columns = -most_cells; columns <= most_cells; columns += kRestartCells) {
          const Alignment found = climb(evaluate({columns, rows}, turn));
          if (found.score > best.score) best = found;
        }
      }
    }
    return best;
  }

  Alignment exhaustive() const {
    Alignment best = evaluate({0, 0}, 0);
    const int last_turn = window_.circular ? window_.turns - 1 : window_.turns;
    for (int turn = -window_.turns; turn <= last_turn; ++turn) {
      for (int rows = -window_.cells; rows <= window_.cells; ++rows) {
        for (int columns = -window_.cells; columns <= window_.cells; ++columns) {
          const Alignment found = evaluate({columns, rows}, turn);
          if (found.score > best.score) best = found;
        }
      }
    }
    return best;
  }

 private:
  /// Moves to the best of the neighbours a step away, where it is better.
  bool stepUp(int step, Alignment& best) const {
    const Alignment from = best;
    for (const int by : {-step, step}) {
      if (std::abs(from.shift.columns + by) <= window_.cells) {
        keepBetter(evaluate({from.shift.columns + by, from.shift.rows}, from.turn), best);
      }
      if (std::abs(from.shift.rows + by) <= window_.cells) {
        keepBetter(evaluate({from.shift.columns, from.shift.rows + by}, from.turn), best);
      }
      int turn = from.turn + by;
      if (window_.circular && turn > window_.turns) turn -= 2 * window_.turns;
      if (window_.circular && turn < -window_.turns) turn += 2 * window_.turns;
      if (std::abs(turn) <= window_.turns) keepBetter(evaluate(from.shift, turn), best);
    }
    return best.score > from.score;
  }

  static void keepBetter(const Alignment& candidate, Alignment& best) {
    if (candidate.score > best.score) best = candidate;
  }

  const QueryPlanes& query_;
  const CellPlanes& learned_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
};

}  // namespace

double scoreAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int turn) {
  const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
  return pairScore(countPairs(query.at(turn), shift, learned), metric.weights) -
         metric.shift_cost * cells - metric.turn_cost * turn * turn;
}

Alignment findAlignment(const QueryPlanes& query, const CellPlanes& learned,
                        const LatticeMetric& metric, const SearchWindow& window,
                        SearchMethod method) {
  const Search search(query, learned, metric, window);
  switch (method) {
    case SearchMethod::kNearestNeighbour:
      return search.evaluate({0, 0}, 0);
    case SearchMethod::kHillClimbing:
      return search.climb(search.evaluate({0, 0}, 0));
    case SearchMethod::kRestarts:
      return search.restarts();
    case SearchMethod::kExhaustive:
      return search.exhaustive();
  }
  return {};
}

}  // namespace place_memory::core
