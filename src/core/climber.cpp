#include "climber.h"

#include <cstdlib>

namespace place_memory::core {
namespace {

/// How far from a summit others are looked for.
constexpr int kAsideCells = 1;
constexpr int kAsideTurns = 5;

}  // namespace

Alignment Climber::evaluate(CellShift shift, int turn) const {
  const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
  const PairCounts counts = counter_.count(query_.at(turn), shift);
  return {shift, turn,
          pairScore(counts, metric_.weights) - metric_.shift_cost * cells -
              metric_.turn_cost * turn * turn};
}

Alignment Climber::climb(Alignment from, int first_step) const {
  for (int step = first_step; step >= 1; step /= 2) {
    while (stepUp(step, from)) {
    }
  }
  return from;
}

Alignment Climber::settle(Alignment summit) const {
  for (;;) {
    Alignment best = summit;
    for (int turn = -kAsideTurns; turn <= kAsideTurns; ++turn) {
      for (int rows = -kAsideCells; rows <= kAsideCells; ++rows) {
        for (int columns = -kAsideCells; columns <= kAsideCells; ++columns) {
          tryAlignment({summit.shift.columns + columns, summit.shift.rows + rows},
                       summit.turn + turn, best);
        }
      }
    }
    if (!(best.score > summit.score)) return summit;
    summit = climb(best, 1);
  }
}

/// Moves to the best of the neighbours a step away, where it is better.
bool Climber::stepUp(int step, Alignment& best) const {
  const Alignment from = best;
  for (const int by : {-step, step}) {
    tryAlignment({from.shift.columns + by, from.shift.rows}, from.turn, best);
    tryAlignment({from.shift.columns, from.shift.rows + by}, from.turn, best);
    tryAlignment(from.shift, from.turn + by, best);
  }
  return best.score > from.score;
}

/// Takes it where it lies in the window and scores higher.
void Climber::tryAlignment(CellShift shift, int turn, Alignment& best) const {
  if (std::abs(shift.columns) > window_.cells || std::abs(shift.rows) > window_.cells) return;
  if (window_.circular && turn > window_.turns) turn -= 2 * window_.turns;
  if (window_.circular && turn < -window_.turns) turn += 2 * window_.turns;
  if (std::abs(turn) > window_.turns) return;
  const Alignment tried = evaluate(shift, turn);
  if (tried.score > best.score) best = tried;
}

}  // namespace place_memory::core
