#include "full_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "support/parallel_for.h"

namespace place_memory::measure {
namespace {

constexpr int kGroupSide = 3;
constexpr int kGroupRotations = 6;
constexpr double kOne = 65536.0;  // of the fixed point
constexpr std::size_t kRows = core::kGridSize;

/// Bounds are sums of rounded terms, and scores sums of doubles in some order.
constexpr double kSlack = 1e-6;

enum Class : std::size_t { kEmpty = 0, kUnsensed = 1, kOccupied = 2 };

std::int32_t fixed(double value) { return static_cast<std::int32_t>(std::ceil(value * kOne)); }

/// What a pair counts beyond what its two cells would count beside unsensed ones.
double pairFactor(const core::PairWeights& w, std::size_t recognition, std::size_t learned) {
  return w[recognition][learned] - w[recognition][kUnsensed] - w[kUnsensed][learned] +
         w[kUnsensed][kUnsensed];
}

core::PairFactors factors(const core::PairWeights& w, bool good) {
  const auto factor = [&](std::size_t recognition, std::size_t learned) {
    const double value = pairFactor(w, recognition, learned);
    return (value > 0.0) == good ? fixed(value) : 0;
  };
  return {factor(kOccupied, kOccupied), factor(kOccupied, kEmpty), factor(kEmpty, kOccupied),
          factor(kEmpty, kEmpty)};
}

std::array<core::QueryRow, kRows> shifted(const core::CellPlanes& planes, int columns, int rows) {
  std::array<core::QueryRow, kRows> result;
  const auto move = [columns](std::uint64_t row) {
    return columns >= 0 ? row << columns : row >> -columns;
  };
  for (int to = std::max(0, rows); to < std::min(core::kGridSize, core::kGridSize + rows); ++to) {
    const auto from = static_cast<std::size_t>(to - rows);
    result[static_cast<std::size_t>(to)] = {move(planes.occupied[from]), move(planes.empty[from])};
  }
  return result;
}

core::BlockScores sum(core::BlockScores a, const core::BlockScores& b) {
  for (std::size_t slot = 0; slot < a.size(); ++slot) a[slot] += b[slot];
  return a;
}

bool beats(const ScoredPlace& a, const ScoredPlace& b) {
  return b.id == core::kNoPlace || a.score > b.score || (a.score == b.score && a.id < b.id);
}

}  // namespace

FullSearch::FullSearch(const core::QueryPlanes& query, const core::LatticeMetric& metric,
                       const core::SearchWindow& window)
    : query_(query),
      metric_(metric),
      window_(window),
      good_(factors(metric.weights, true)),
      bad_(factors(metric.weights, false)) {
  if (metric.overlap_only) throw std::invalid_argument("the metric counts overlapping cells only");
  const int last_rotation = window.circular ? window.rotations - 1 : window.rotations;
  for (int rotation = -window.rotations; rotation <= last_rotation; rotation += kGroupRotations) {
    const int last_of_group = std::min(rotation + kGroupRotations - 1, last_rotation);
    for (int row = -window.cells; row <= window.cells; row += kGroupSide) {
      for (int column = -window.cells; column <= window.cells; column += kGroupSide) {
        add({rotation, last_of_group, column, row}, coarse_);
        first_fine_.push_back(fine_.all.size());
        for (int t = rotation; t <= last_of_group; ++t) add({t, t, column, row}, fine_);
      }
    }
  }
  first_fine_.push_back(fine_.all.size());
}

template <typename Call>
void FullSearch::forEachTransform(const Group& group, const Call& call) const {
  const int last_row = std::min(group.first_row + kGroupSide - 1, window_.cells);
  const int last_column = std::min(group.first_column + kGroupSide - 1, window_.cells);
  for (int rotation = group.first_rotation; rotation <= group.last_rotation; ++rotation) {
    for (int row = group.first_row; row <= last_row; ++row) {
      for (int column = group.first_column; column <= last_column; ++column) {
        call(rotation, core::CellShift{column, row});
      }
    }
  }
}

void FullSearch::add(const Group& group, Groups& groups) const {
  const core::PairWeights& w = metric_.weights;
  const double unsensed = w[kUnsensed][kUnsensed];
  std::array<core::QueryRow, kRows> some{}, all;
  all.fill({~std::uint64_t{0}, ~std::uint64_t{0}});
  double most = -INFINITY;
  forEachTransform(group, [&](int rotation, core::CellShift shift) {
    int occupied = 0, empty = 0;
    const auto rows = shifted(query_.at(rotation), shift.columns, shift.rows);
    for (std::size_t i = 0; i < kRows; ++i) {
      some[i].occupied |= rows[i].occupied;
      some[i].empty |= rows[i].empty;
      all[i].occupied &= rows[i].occupied;
      all[i].empty &= rows[i].empty;
      occupied += __builtin_popcountll(rows[i].occupied);
      empty += __builtin_popcountll(rows[i].empty);
    }
    const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
    most =
        std::max(most, occupied * (w[kOccupied][kUnsensed] - unsensed) +
                           empty * (w[kEmpty][kUnsensed] - unsensed) - metric_.shift_cost * cells -
                           metric_.rotation_cost * rotation * rotation);
  });
  groups.all.push_back(group);
  groups.somewhere.insert(groups.somewhere.end(), some.begin(), some.end());
  groups.everywhere.insert(groups.everywhere.end(), all.begin(), all.end());
  groups.offsets.push_back(static_cast<std::int64_t>(std::ceil(most * kOne)));
}

double FullSearch::termOf(const core::CellTotals& totals) const {
  const core::PairWeights& w = metric_.weights;
  const double unsensed = w[kUnsensed][kUnsensed];
  return totals.occupied * (w[kUnsensed][kOccupied] - unsensed) +
         totals.empty * (w[kUnsensed][kEmpty] - unsensed) + core::kGridCells * unsensed;
}

bool FullSearch::mayBeBest(std::int64_t bound, const core::CellTotals& totals,
                           const ScoredPlace& best) const {
  return best.id == core::kNoPlace ||
         static_cast<double>(bound) / kOne + termOf(totals) >= best.score - kSlack;
}

ScoredPlace FullSearch::best(const core::PlaceIndex& places, const ScoredPlace& known) const {
  constexpr std::size_t kAtATime = 32;  // blocks, which stay in the cache for all groups
  const std::size_t blocks = places.blocks().size();
  ScoredPlace best = known;
  std::mutex mutex;
  support::parallelFor((blocks + kAtATime - 1) / kAtATime, [&](std::size_t i) {
    ScoredPlace own;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      own = best;
    }
    search(places, i * kAtATime, std::min(blocks, (i + 1) * kAtATime), own);
    const std::lock_guard<std::mutex> lock(mutex);
    if (beats(own, best)) best = own;
  });
  return best;
}

void FullSearch::search(const core::PlaceIndex& places, std::size_t first_block,
                        std::size_t last_block, ScoredPlace& best) const {
  constexpr std::size_t kGroups = 128;  // at a time, for the cache's sake too
  std::array<core::BlockScores, kGroups> bounds;
  for (std::size_t first = 0; first < coarse_.all.size(); first += kGroups) {
    const std::size_t count = std::min(kGroups, coarse_.all.size() - first);
    for (std::size_t b = first_block; b < last_block; ++b) {
      const core::PlaceBlock& block = *places.blocks()[b];
      const core::BlockBest most =
          kernel_({block.planes().rows.data(), coarse_.somewhere.data() + first * kRows, kRows,
                   count, good_, coarse_.offsets.data() + first},
                  bounds.data());
      bool may_be_best = false;
      for (std::size_t slot = 0; slot < block.size() && !may_be_best; ++slot) {
        may_be_best = mayBeBest(most.score[slot], block.totals(slot), best);
      }
      if (!may_be_best) continue;
      for (std::size_t i = 0; i < count; ++i) searchGroup(block, first + i, bounds[i], best);
    }
  }
}

void FullSearch::searchGroup(const core::PlaceBlock& block, std::size_t group,
                             const core::BlockScores& bounds, ScoredPlace& best) const {
  const core::BlockRow* const rows = block.planes().rows.data();
  const auto penalties = [&](const Groups& groups, std::size_t first, std::size_t count,
                             core::BlockScores* scores) {
    constexpr std::array<std::int64_t, kGroupRotations> kNone{};
    kernel_({rows, groups.everywhere.data() + first * kRows, kRows, count, bad_, kNone.data()},
            scores);
  };
  std::array<bool, core::kBlockPlaces> left;
  left.fill(true);
  const auto someLeft = [&](const core::BlockScores& most) {
    bool some = false;
    for (std::size_t slot = 0; slot < block.size(); ++slot) {
      left[slot] = left[slot] && mayBeBest(most[slot], block.totals(slot), best);
      some = some || left[slot];
    }
    return some;
  };
  if (!someLeft(bounds)) return;
  std::array<core::BlockScores, kGroupRotations> gained, lost;
  penalties(coarse_, group, 1, lost.data());
  if (!someLeft(sum(bounds, lost[0]))) return;

  const std::size_t first = first_fine_[group];
  const std::size_t count = first_fine_[group + 1] - first;
  kernel_({rows, fine_.somewhere.data() + first * kRows, kRows, count, good_,
           fine_.offsets.data() + first},
          gained.data());
  penalties(fine_, first, count, lost.data());
  for (std::size_t i = 0; i < count; ++i) {
    const core::BlockScores most = sum(gained[i], lost[i]);
    for (std::size_t slot = 0; slot < block.size(); ++slot) {
      if (!left[slot] || !mayBeBest(most[slot], block.totals(slot), best)) continue;
      tryTransforms(block, slot, fine_.all[first + i], best);
    }
  }
}

void FullSearch::tryTransforms(const core::PlaceBlock& block, std::size_t slot, const Group& group,
                               ScoredPlace& best) const {
  const core::CellPlanes cells = block.planes().get(slot);
  forEachTransform(group, [&](int rotation, core::CellShift shift) {
    const ScoredPlace found{block[slot], core::scoreAt(query_, cells, metric_, shift, rotation)};
    if (beats(found, best)) best = found;
  });
}

}  // namespace place_memory::measure
