#include "core/match/restart_search.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

/// So few places are all looked at closely; of more, a part that grows less than they do, but of
/// very many more than this: the best of them are ever closer to each other.
constexpr double kAllClose = 48.0;
constexpr double kCloseGrowth = 0.75;
constexpr double kMany = 1000.0;
constexpr double kGrowthOfMany = 0.2;  ///< of close looks and climbs, beside their own
/// So many are climbed for, for each turn of the close look; of more or fewer places, a number that
/// grows less than they do.
constexpr double kClimbed = 1.0;
constexpr double kClimbedGrowth = 0.5;

/// So many of the first are settled, more of many places: the order of the others matters less.
constexpr double kSettled = 4.0;
constexpr double kSettledGrowthOfMany = 0.16;

constexpr std::size_t kRankedATask = 64;
constexpr std::size_t kClimbedATask = 8;

std::size_t tasksOf(std::size_t places, std::size_t a_task) {
  return (places + a_task - 1) / a_task;
}

/// Takes the best `count` away, in the order in which they lie in memory.
std::vector<Glimpse> takeBest(std::size_t count, std::vector<Glimpse>& seen) {
  count = std::min(count, seen.size());
  const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(seen.begin(), end, seen.end(), [](const Glimpse& a, const Glimpse& b) {
    return a.score != b.score ? a.score > b.score : a.place < b.place;
  });
  std::vector<Glimpse> best(seen.begin(), end);
  std::sort(best.begin(), best.end(),
            [](const Glimpse& a, const Glimpse& b) { return a.place < b.place; });
  seen.erase(seen.begin(), end);
  return best;
}

}  // namespace

RestartSearch::RestartSearch(const QueryPlanes& query, const PlaceIndex& places,
                             const LatticeMetric& metric, const SearchWindow& window,
                             const std::function<void()>& poll, support::WorkerPool& pool)
    : query_(query),
      metric_(metric),
      window_(window),
      poll_(poll),
      pool_(pool),
      fixed_(metric),
      lattice_(query, fixed_, window, kCloseLook, pool),
      looks_(places, fixed_, poll, pool),
      size_(places.size()) {}

bool RestartSearch::isBetter(const Ranked* a, const Ranked* b) {
  if (a->alignment.score != b->alignment.score) return a->alignment.score > b->alignment.score;
  return a->place < b->place;
}

std::vector<PlaceAlignment> RestartSearch::run() const {
  poll_();
  std::vector<Ranked> places = rank();
  std::vector<Ranked*> ranked;
  ranked.reserve(places.size());
  for (Ranked& place : places) ranked.push_back(&place);
  const std::size_t kept = std::max(climbed(), kMostRanked);
  if (ranked.size() > kept) {
    std::nth_element(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(kept),
                     ranked.end(), isBetter);
    ranked.resize(kept);
  }
  finish(ranked);
  std::vector<PlaceAlignment> answer;
  answer.reserve(ranked.size());
  for (const Ranked* place : ranked) {
    answer.push_back({looks_.idOf(place->place), place->alignment});
  }
  return answer;
}

double RestartSearch::timesMany(double growth) const {
  return std::pow(std::max(1.0, static_cast<double>(size_) / kMany), growth);
}

std::size_t RestartSearch::grown(double of_few, double growth) const {
  const double times = static_cast<double>(size_) / kAllClose;
  return static_cast<std::size_t>(of_few * std::pow(times, growth) * timesMany(kGrowthOfMany));
}

std::size_t RestartSearch::climbed() const {
  if (metric_.overlap_only) return size_;
  const double of_few = kClimbed * static_cast<double>(lattice_.turns());
  return std::max(kSurelyClimbed, grown(of_few, kClimbedGrowth));
}

std::vector<RestartSearch::Ranked> RestartSearch::rank() const {
  const std::size_t close = grown(kAllClose, kCloseGrowth);
  std::vector<Ranked> ranked;
  // Looks take cells beyond the rim as unsensed: they show starts for another metric, but not which
  // places score high.
  if (metric_.overlap_only || close >= size_) {
    lookClosely(looks_.everyPlace(), ranked);
  } else {
    const StartLattice lattice(query_, fixed_, window_, kFirstLook, pool_);
    std::vector<Glimpse> seen = looks_.lookAtAll(lattice);
    countLook(lattice, seen.size());
    const std::vector<Glimpse> best = takeBest(close, seen);
    lookClosely(best, ranked);
    rankOthers(lattice, takeBest(kMostRanked - std::min(close, kMostRanked), seen), ranked);
  }
  return ranked;
}

void RestartSearch::countLook(const StartLattice& lattice, std::size_t places) const {
  rows_ += kCoarsestRows * lattice.size() * places;
}

void RestartSearch::countEvaluations(const Climber& climber) const {
  rows_ += kGridSize * climber.evaluations();
}

void RestartSearch::lookClosely(const std::vector<Glimpse>& seen,
                                std::vector<Ranked>& ranked) const {
  countLook(lattice_, seen.size());
  ranked.resize(seen.size());
  const auto lookTogether = [&](std::size_t task) {
    LookScores scores;
    const std::size_t end = std::min(seen.size(), (task + 1) * kRankedATask);
    for (std::size_t first = task * kRankedATask; first < end; first += kBlockPlaces) {
      const std::size_t count = std::min(kBlockPlaces, end - first);
      looks_.look(lattice_, seen.data() + first, seen.data() + first + count, scores);
      for (std::size_t i = 0; i < count; ++i) {
        Ranked& place = ranked[first + i];
        place.place = seen[first + i].place;
        const CellPlanes cells = looks_.cellsOf(place.place);
        const Climber climber(query_, cells, metric_, window_);
        place.starts = chooseStarts(climber, lattice_, scores, i);
        countEvaluations(climber);
        place.alignment = place.starts.front();
      }
    }
  };
  pool_.run(tasksOf(seen.size(), kRankedATask), lookTogether, poll_);
}

void RestartSearch::rankOthers(const StartLattice& lattice, const std::vector<Glimpse>& seen,
                               std::vector<Ranked>& ranked) const {
  const std::size_t before = ranked.size();
  ranked.resize(before + seen.size());
  const auto rankTogether = [&](std::size_t task) {
    const std::size_t end = std::min(seen.size(), (task + 1) * kRankedATask);
    for (std::size_t i = task * kRankedATask; i < end; ++i) {
      Ranked& place = ranked[before + i];
      place.place = seen[i].place;
      const CellPlanes cells = looks_.cellsOf(place.place);
      const Alignment start = lattice.start(seen[i].start);
      const Climber climber(query_, cells, metric_, window_);
      place.alignment = climber.evaluate(start.shift, start.turn);
      countEvaluations(climber);
      place.starts.add(place.alignment);
    }
  };
  pool_.run(tasksOf(seen.size(), kRankedATask), rankTogether, poll_);
}

void RestartSearch::climb(const std::vector<Ranked*>& places) const {
  const auto climbTogether = [&](std::size_t task) {
    const std::size_t end = std::min(places.size(), (task + 1) * kClimbedATask);
    for (std::size_t i = task * kClimbedATask; i < end; ++i) {
      Ranked& place = *places[i];
      const CellPlanes cells = looks_.cellsOf(place.place);
      Climber climber(query_, cells, metric_, window_);
      place.summits = climbFromStarts(climber, place.starts);
      place.alignment = place.summits.front();
      countEvaluations(climber);
    }
  };
  pool_.run(tasksOf(places.size(), kClimbedATask), climbTogether, poll_);
}

void RestartSearch::settleSummits(const std::vector<Ranked*>& places) const {
  const auto settleOne = [&](std::size_t i) {
    const CellPlanes cells = looks_.cellsOf(places[i]->place);
    Climber climber(query_, cells, metric_, window_);
    places[i]->alignment = settle(climber, places[i]->summits);
    places[i]->settled = true;
    countEvaluations(climber);
  };
  pool_.run(places.size(), settleOne, poll_);
}

void RestartSearch::finish(std::vector<Ranked*>& ranked) const {
  const auto settled = static_cast<std::size_t>(kSettled * timesMany(kSettledGrowthOfMany));
  for (std::size_t first = climbed();; first = std::max(kSurelyClimbed, settled)) {
    first = std::min(first, ranked.size());
    const auto end = ranked.begin() + static_cast<std::ptrdiff_t>(first);
    std::partial_sort(ranked.begin(), end, ranked.end(), isBetter);
    std::vector<Ranked*> to_climb, to_settle;
    for (std::size_t i = 0; i < first; ++i) {
      if (ranked[i]->summits.empty()) to_climb.push_back(ranked[i]);
      if (i < settled && !ranked[i]->settled) to_settle.push_back(ranked[i]);
    }
    if (to_climb.empty() && to_settle.empty()) break;
    if (to_climb.empty()) {
      settleSummits(to_settle);
    } else {
      climb(to_climb);
    }
  }
  std::sort(ranked.begin(), ranked.end(), isBetter);
  if (ranked.size() > kMostRanked) ranked.resize(kMostRanked);
}

}  // namespace place_memory::core
