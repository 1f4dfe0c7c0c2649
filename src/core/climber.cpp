#include "climber.h"

#include <algorithm>
#include <cstdlib>

#include "pair_kernel.h"

namespace place_memory::core {
namespace {

/// How far from a summit others are looked for.
constexpr int kAsideCells = 1;
constexpr int kAsideTurns = 5;

std::size_t transformsOf(const SearchWindow& window) {
  const int side = 2 * window.cells + 1;
  const int transforms = side * side * (2 * window.turns + 1);
  return static_cast<std::size_t>(transforms);
}

}  // namespace

Climber::Climber(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                 const SearchWindow& window)
    : query_(query), learned_(learned), metric_(metric), window_(window), linear_(metric.weights) {
  const std::uint64_t* o = learned.occupied.data();
  const std::uint64_t* e = learned.empty.data();
  const PlaneCounts n = countPlanes({o, e, o, e, kGridSize, 0});
  of_place_ = linear_.unsensed + static_cast<double>(n.occupied) * linear_.learned_occupied +
              static_cast<double>(n.empty) * linear_.learned_empty;
}

Alignment Climber::evaluate(CellShift shift, int turn) const {
  const CellPlanes& turned = query_.at(turn);
  const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
  const double cost = metric_.shift_cost * cells + metric_.turn_cost * turn * turn;
  if (metric_.overlap_only) {
    const PairCounts pairs = countOverlap(turned, query_.reach(turn), shift, learned_);
    return {shift, turn, pairScore(pairs, metric_.weights) - cost};
  }
  const int first = std::max(0, shift.rows);
  const int end = std::min(kGridSize, kGridSize + shift.rows);
  const int from = first - shift.rows;
  const PlaneCounts n = countPlanes({turned.occupied.data() + from, turned.empty.data() + from,
                                     learned_.occupied.data() + first,
                                     learned_.empty.data() + first, end - first, shift.columns});
  const auto points = [](std::uint64_t count, double each) {
    return static_cast<double>(static_cast<std::int64_t>(count)) * each;
  };
  const double of_pairs = (points(n.occupied_occupied, linear_.occupied_occupied) +
                           points(n.occupied_empty, linear_.occupied_empty)) +
                          (points(n.empty_occupied, linear_.empty_occupied) +
                           points(n.empty_empty, linear_.empty_empty));
  const double of_query = points(n.occupied, linear_.occupied) + points(n.empty, linear_.empty);
  return {shift, turn, of_place_ + (of_pairs + of_query) - cost};
}

void Climber::climb(CellShift shift, int turn, int first_step) {
  if (tried_.empty()) tried_.resize(transformsOf(window_));
  if (isNew(shift, turn)) summits_.push_back(climbFrom(evaluate(shift, turn), first_step));
}

void Climber::settle(const Alignment& summit) {
  if (tried_.empty()) tried_.resize(transformsOf(window_));
  Alignment at = summit;
  for (;;) {
    Alignment near = at;
    for (int turn = -kAsideTurns; turn <= kAsideTurns; ++turn) {
      for (int rows = -kAsideCells; rows <= kAsideCells; ++rows) {
        for (int columns = -kAsideCells; columns <= kAsideCells; ++columns) {
          tryAlignment({at.shift.columns + columns, at.shift.rows + rows}, at.turn + turn, near);
        }
      }
    }
    if (!(near.score > at.score)) break;
    at = climbFrom(near, 1);
  }
  summits_.push_back(at);
}

std::vector<Alignment> Climber::summits() const {
  std::vector<Alignment> sorted = summits_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
  return sorted;
}

Alignment Climber::climbFrom(Alignment from, int first_step) {
  for (int step = first_step; step >= 1; step /= 2) {
    while (stepUp(step, from)) {
    }
  }
  return from;
}

/// Moves to the best of the neighbours a step away, where it is better.
bool Climber::stepUp(int step, Alignment& at) {
  const Alignment from = at;
  for (const int by : {-step, step}) {
    tryAlignment({from.shift.columns + by, from.shift.rows}, from.turn, at);
    tryAlignment({from.shift.columns, from.shift.rows + by}, from.turn, at);
    tryAlignment(from.shift, from.turn + by, at);
  }
  return at.score > from.score;
}

void Climber::tryAlignment(CellShift shift, int turn, Alignment& at) {
  if (std::abs(shift.columns) > window_.cells || std::abs(shift.rows) > window_.cells) return;
  if (window_.circular && turn > window_.turns) turn -= 2 * window_.turns;
  if (window_.circular && turn < -window_.turns) turn += 2 * window_.turns;
  if (std::abs(turn) > window_.turns || !isNew(shift, turn)) return;
  const Alignment tried = evaluate(shift, turn);
  if (tried.score > at.score) at = tried;
}

bool Climber::isNew(CellShift shift, int turn) {
  const int side = 2 * window_.cells + 1;
  const int index = ((turn + window_.turns) * side + shift.rows + window_.cells) * side +
                    shift.columns + window_.cells;
  auto tried = tried_[static_cast<std::size_t>(index)];
  if (tried) return false;
  tried = true;
  return true;
}

}  // namespace place_memory::core
