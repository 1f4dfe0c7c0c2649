#include "restart_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::core {
namespace {

/// So many places are all looked at closely; of more, a part that grows less than they do.
constexpr double kAllClose = 1024.0;
constexpr double kCloseGrowth = 0.7;
/// Likewise those that are climbed for: all of so few.
constexpr double kLeastClimbed = 32.0;
constexpr double kClimbedGrowth = 0.6;

/// So many of the first are settled: the order of the others matters less.
constexpr std::size_t kSurelySettled = 12;

constexpr std::size_t kUnclimbedATask = 64;

std::size_t partOf(std::size_t places, double least, double growth) {
  const double times = std::max(1.0, static_cast<double>(places) / kAllClose);
  return static_cast<std::size_t>(least * std::pow(times, growth));
}

bool isBetter(const Glimpse& a, const Glimpse& b) {
  return a.score != b.score ? a.score > b.score : a.place < b.place;
}

/// Brings the best `count` to the front, in any order; returns the end of them.
Glimpse* selectBest(Glimpse* begin, std::size_t count, Glimpse* end) {
  if (count >= static_cast<std::size_t>(end - begin)) return end;
  std::nth_element(begin, begin + count, end, isBetter);
  return begin + count;
}

}  // namespace

RestartSearch::RestartSearch(const QueryPlanes& query, const PlaceIndex& places,
                             const LatticeMetric& metric, const SearchWindow& window,
                             const std::function<void()>& poll, WorkerPool& pool)
    : query_(query),
      metric_(metric),
      window_(window),
      poll_(poll),
      pool_(pool),
      fixed_(metric),
      looks_(places, fixed_, poll, pool),
      size_(places.size()) {}

std::vector<PlaceAlignment> RestartSearch::run() const {
  poll_();
  std::vector<Glimpse> seen = shortlist();
  const StartLattice lattice(query_, fixed_, window_, kCloseLook, pool_);
  std::vector<Ranked> ranked = rank(lattice, seen);
  finish(lattice, ranked);
  std::vector<PlaceAlignment> answer;
  for (std::size_t i = 0; i < std::min(ranked.size(), kMostRanked); ++i) {
    answer.push_back({&looks_.entryOf(ranked[i].glimpse.place), ranked[i].alignment});
  }
  return answer;
}

std::vector<Glimpse> RestartSearch::shortlist() const {
  const std::size_t close = partOf(size_, kAllClose, kCloseGrowth);
  if (metric_.overlap_only || close >= size_) return looks_.everyPlace();
  const StartLattice lattice(query_, fixed_, window_, kFirstLook, pool_);
  std::vector<Glimpse> seen = looks_.lookFirst(lattice);
  selectBest(seen.data(), close, seen.data() + seen.size());
  seen.resize(close);
  // In the order in which they lie in memory.
  std::sort(seen.begin(), seen.end(),
            [](const Glimpse& a, const Glimpse& b) { return a.place < b.place; });
  return seen;
}

std::vector<RestartSearch::Ranked> RestartSearch::rank(const StartLattice& lattice,
                                                       std::vector<Glimpse>& seen) const {
  Glimpse* const end = seen.data() + seen.size();
  Glimpse* best_end = end;
  std::vector<Ranked> ranked;
  const std::size_t climbed = partOf(size_, kLeastClimbed, kClimbedGrowth);
  // Looks take cells beyond the rim as unsensed: they show starts for another metric, but not which
  // places score high.
  if (!metric_.overlap_only && climbed < seen.size()) {
    looks_.lookClosely(lattice, seen.data(), end);
    best_end = selectBest(seen.data(), climbed, end);
    const std::size_t others = kMostRanked - std::min(climbed, kMostRanked);
    rankUnclimbed(lattice, best_end, selectBest(best_end, others, end), ranked);
  }
  const std::size_t unclimbed = ranked.size();
  for (Glimpse* glimpse = seen.data(); glimpse != best_end; ++glimpse) {
    ranked.push_back({*glimpse, {}, {}, false});
  }
  std::vector<Ranked*> to_climb;
  for (std::size_t i = unclimbed; i < ranked.size(); ++i) to_climb.push_back(&ranked[i]);
  climb(lattice, to_climb);
  return ranked;
}

void RestartSearch::rankUnclimbed(const StartLattice& lattice, const Glimpse* begin,
                                  const Glimpse* end, std::vector<Ranked>& ranked) const {
  const std::size_t before = ranked.size();
  ranked.resize(before + static_cast<std::size_t>(end - begin));
  const auto rankTogether = [&](std::size_t task) {
    const std::size_t first = task * kUnclimbedATask;
    for (std::size_t i = first; i < std::min(first + kUnclimbedATask, ranked.size() - before);
         ++i) {
      Alignment at = lattice.start(begin[i].start);
      at.score = scoreAt(query_, looks_.cellsOf(begin[i].place), metric_, at.shift, at.turn);
      ranked[before + i] = {begin[i], at, {}, false};
    }
  };
  pool_.run((ranked.size() - before + kUnclimbedATask - 1) / kUnclimbedATask, rankTogether, poll_);
}

void RestartSearch::climb(const StartLattice& lattice, const std::vector<Ranked*>& places) const {
  const auto climbTogether = [&](std::size_t task) {
    const std::size_t first = task * kBlockPlaces;
    const std::size_t count = std::min(kBlockPlaces, places.size() - first);
    std::array<Glimpse, kBlockPlaces> glimpses;
    for (std::size_t i = 0; i < count; ++i) glimpses[i] = places[first + i]->glimpse;
    std::vector<BlockScores> scores;
    looks_.scoreClosely(lattice, glimpses.data(), glimpses.data() + count, scores);
    for (std::size_t i = 0; i < count; ++i) {
      Ranked& place = *places[first + i];
      const CellPlanes cells = looks_.cellsOf(place.glimpse.place);
      Climber climber(query_, cells, metric_, window_);
      place.summits = climbFromStarts(climber, lattice, scores, i);
      place.alignment = place.summits.front();
    }
  };
  pool_.run((places.size() + kBlockPlaces - 1) / kBlockPlaces, climbTogether, poll_);
}

void RestartSearch::settleSummits(const std::vector<Ranked*>& places) const {
  const auto settleOne = [&](std::size_t i) {
    const CellPlanes cells = looks_.cellsOf(places[i]->glimpse.place);
    Climber climber(query_, cells, metric_, window_);
    places[i]->alignment = settle(climber, places[i]->summits);
    places[i]->settled = true;
  };
  pool_.run(places.size(), settleOne, poll_);
}

void RestartSearch::finish(const StartLattice& lattice, std::vector<Ranked>& ranked) const {
  for (;;) {
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
      if (a.alignment.score != b.alignment.score) return a.alignment.score > b.alignment.score;
      return a.glimpse.place < b.glimpse.place;
    });
    std::vector<Ranked*> to_climb, to_settle;
    for (std::size_t i = 0; i < std::min(kSurelyClimbed, ranked.size()); ++i) {
      if (ranked[i].summits.empty()) to_climb.push_back(&ranked[i]);
      if (i < kSurelySettled && !ranked[i].settled) to_settle.push_back(&ranked[i]);
    }
    if (to_climb.empty() && to_settle.empty()) return;
    if (to_climb.empty()) {
      settleSummits(to_settle);
    } else {
      climb(lattice, to_climb);
    }
  }
}

}  // namespace place_memory::core
