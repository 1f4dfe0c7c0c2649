#include "core/match/climber.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace place_memory::core {
namespace {

/// How far from a summit others are looked for.
constexpr int kAsideCells = 1;
constexpr int kAsideRotations = 5;

std::size_t transformsOf(const SearchWindow& window) {
  const int side = 2 * window.cells + 1;
  const int transforms = side * side * (2 * window.rotations + 1);
  return static_cast<std::size_t>(transforms);
}

/// Transforms that are counted at once.
constexpr std::size_t kTogether = 16;

double points(std::uint64_t count, double each) {
  return static_cast<double>(static_cast<std::int64_t>(count)) * each;
}

}  // namespace

Climber::Climber(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                 const SearchWindow& window)
    : query_(query), learned_(learned), metric_(metric), window_(window), linear_(metric.weights) {
  const std::uint64_t* o = learned.occupied.data();
  const std::uint64_t* e = learned.empty.data();
  const PlaneCounts n = countPlanes({o, e, o, e, kGridSize, 0});
  of_place_ = linear_.unsensed + points(n.occupied, linear_.learned_occupied) +
              points(n.empty, linear_.learned_empty);
}

Alignment Climber::evaluate(CellShift shift, int rotation) const {
  Alignment at{shift, rotation};
  evaluate(&at, 1);
  return at;
}

void Climber::evaluate(Alignment* begin, std::size_t size) const {
  static const TransformKernel kernel = chosenKernel(transformKernels());
  evaluations_ += size;
  std::array<MovedPlanes, kTogether> moved;
  std::array<PlaneCounts, kTogether> counts;
  for (std::size_t first = 0; first < size; first += kTogether) {
    Alignment* const some = begin + first;
    const std::size_t together = std::min(kTogether, size - first);
    if (metric_.overlap_only) {
      for (std::size_t i = 0; i < together; ++i) some[i].score = overlapScore(some[i]);
      continue;
    }
    for (std::size_t i = 0; i < together; ++i)
      moved[i] = {&query_.at(some[i].rotation), some[i].shift};
    kernel(learned_, moved.data(), together, counts.data());
    for (std::size_t i = 0; i < together; ++i) some[i].score = score(counts[i]) - cost(some[i]);
  }
}

double Climber::cost(const Alignment& at) const {
  const int cells = at.shift.columns * at.shift.columns + at.shift.rows * at.shift.rows;
  return metric_.shift_cost * cells + metric_.rotation_cost * at.rotation * at.rotation;
}

double Climber::overlapScore(const Alignment& at) const {
  const PairCounts pairs =
      countOverlap(query_.at(at.rotation), query_.reach(at.rotation), at.shift, learned_);
  return pairScore(pairs, metric_.weights) - cost(at);
}

double Climber::score(const PlaneCounts& n) const {
  const double of_pairs = (points(n.occupied_occupied, linear_.occupied_occupied) +
                           points(n.occupied_empty, linear_.occupied_empty)) +
                          (points(n.empty_occupied, linear_.empty_occupied) +
                           points(n.empty_empty, linear_.empty_empty));
  const double of_query = points(n.occupied, linear_.occupied) + points(n.empty, linear_.empty);
  return of_place_ + (of_pairs + of_query);
}

void Climber::begin() {
  if (!tried_.empty()) return;
  tried_.resize(transformsOf(window_));
  proposed_.reserve(kTogether);
}

void Climber::climb(CellShift shift, int rotation, int first_step) {
  begin();
  if (isNew(shift, rotation)) summits_.push_back(climbFrom(evaluate(shift, rotation), first_step));
}

void Climber::refine(const Alignment& summit) {
  begin();
  Alignment at = summit;
  for (;;) {
    Alignment near = at;
    for (int rotation = -kAsideRotations; rotation <= kAsideRotations; ++rotation) {
      for (int rows = -kAsideCells; rows <= kAsideCells; ++rows) {
        for (int columns = -kAsideCells; columns <= kAsideCells; ++columns) {
          propose({at.shift.columns + columns, at.shift.rows + rows}, at.rotation + rotation);
        }
      }
    }
    takeBest(near);
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
    propose({from.shift.columns + by, from.shift.rows}, from.rotation);
    propose({from.shift.columns, from.shift.rows + by}, from.rotation);
    propose(from.shift, from.rotation + by);
  }
  takeBest(at);
  return at.score > from.score;
}

void Climber::propose(CellShift shift, int rotation) {
  if (std::abs(shift.columns) > window_.cells || std::abs(shift.rows) > window_.cells) return;
  rotation = window_.wrapped(rotation);
  if (std::abs(rotation) > window_.rotations || !isNew(shift, rotation)) return;
  // Set where it lies: a copy would wait until its parts are written.
  Alignment& proposed = proposed_.emplace_back();
  proposed.shift = shift;
  proposed.rotation = rotation;
}

void Climber::takeBest(Alignment& at) {
  evaluate(proposed_.data(), proposed_.size());
  for (const Alignment& tried : proposed_) {
    if (tried.score > at.score) at = tried;
  }
  proposed_.clear();
}

bool Climber::isNew(CellShift shift, int rotation) {
  const int side = 2 * window_.cells + 1;
  const int index = ((rotation + window_.rotations) * side + shift.rows + window_.cells) * side +
                    shift.columns + window_.cells;
  auto tried = tried_[static_cast<std::size_t>(index)];
  if (tried) return false;
  tried = true;
  return true;
}

}  // namespace place_memory::core
