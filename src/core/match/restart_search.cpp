#include "core/match/restart_search.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

/// So few places are all seeded; of more, a part that grows less than they do, but of very many
/// more than this: the best of them are ever closer to each other.
constexpr double kAllSeeded = 48.0;
constexpr double kSeededGrowth = 0.75;
constexpr double kMany = 1000.0;
constexpr double kGrowthOfMany = 0.2;  ///< of seeding and climbs, beside their own
/// So many are climbed for, for each rotation of the seed grid; of more or fewer places, a number
/// that grows less than they do.
constexpr double kClimbed = 1.0;
constexpr double kClimbedGrowth = 0.5;

/// So many of the first are refined, more of many places: the order of the others matters less.
constexpr double kRefined = 4.0;
constexpr double kRefinedGrowthOfMany = 0.16;

constexpr std::size_t kRankedATask = 64;
constexpr std::size_t kClimbedATask = 8;

std::size_t tasksOf(std::size_t places, std::size_t a_task) {
  return (places + a_task - 1) / a_task;
}

/// Takes the best `count` away, in the order in which they lie in memory.
std::vector<ScreenedPlace> takeBest(std::size_t count, std::vector<ScreenedPlace>& screened) {
  count = std::min(count, screened.size());
  const auto end = screened.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(screened.begin(), end, screened.end(),
                   [](const ScreenedPlace& a, const ScreenedPlace& b) {
                     return a.score != b.score ? a.score > b.score : a.place < b.place;
                   });
  std::vector<ScreenedPlace> best(screened.begin(), end);
  std::sort(best.begin(), best.end(),
            [](const ScreenedPlace& a, const ScreenedPlace& b) { return a.place < b.place; });
  screened.erase(screened.begin(), end);
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
      seed_grid_(query, fixed_, window, kSeeding, pool),
      screening_(places, fixed_, poll, pool),
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
    answer.push_back({screening_.idOf(place->place), place->alignment});
  }
  return answer;
}

double RestartSearch::timesMany(double growth) const {
  return std::pow(std::max(1.0, static_cast<double>(size_) / kMany), growth);
}

std::size_t RestartSearch::grown(double of_few, double growth) const {
  const double times = static_cast<double>(size_) / kAllSeeded;
  return static_cast<std::size_t>(of_few * std::pow(times, growth) * timesMany(kGrowthOfMany));
}

std::size_t RestartSearch::climbed() const {
  if (metric_.overlap_only) return size_;
  const double of_few = kClimbed * static_cast<double>(seed_grid_.rotations());
  return std::max(kSurelyClimbed, grown(of_few, kClimbedGrowth));
}

std::vector<RestartSearch::Ranked> RestartSearch::rank() const {
  const std::size_t seeded = grown(kAllSeeded, kSeededGrowth);
  std::vector<Ranked> ranked;
  // Screening takes cells beyond the rim as unsensed: it shows seeds for another metric, but not
  // which places score high.
  if (metric_.overlap_only || seeded >= size_) {
    seedPlaces(screening_.everyPlace(), ranked);
  } else {
    const SeedGrid grid(query_, fixed_, window_, kScreening, pool_);
    std::vector<ScreenedPlace> screened = screening_.screenAll(grid);
    countScreening(grid, screened.size());
    const std::vector<ScreenedPlace> best = takeBest(seeded, screened);
    seedPlaces(best, ranked);
    rankOthers(grid, takeBest(kMostRanked - std::min(seeded, kMostRanked), screened), ranked);
  }
  return ranked;
}

void RestartSearch::countScreening(const SeedGrid& grid, std::size_t places) const {
  rows_ += kCoarsestRows * grid.size() * places;
}

void RestartSearch::countEvaluations(const Climber& climber) const {
  rows_ += kGridSize * climber.evaluations();
}

void RestartSearch::seedPlaces(const std::vector<ScreenedPlace>& screened,
                               std::vector<Ranked>& ranked) const {
  countScreening(seed_grid_, screened.size());
  ranked.resize(screened.size());
  const auto seedTogether = [&](std::size_t task) {
    SeedScores scores;
    const std::size_t end = std::min(screened.size(), (task + 1) * kRankedATask);
    for (std::size_t first = task * kRankedATask; first < end; first += kBlockPlaces) {
      const std::size_t count = std::min(kBlockPlaces, end - first);
      screening_.score(seed_grid_, screened.data() + first, screened.data() + first + count,
                       scores);
      for (std::size_t i = 0; i < count; ++i) {
        Ranked& place = ranked[first + i];
        place.place = screened[first + i].place;
        const CellPlanes cells = screening_.cellsOf(place.place);
        const Climber climber(query_, cells, metric_, window_);
        place.seeds = chooseSeeds(climber, seed_grid_, scores, i);
        countEvaluations(climber);
        place.alignment = place.seeds.front();
      }
    }
  };
  pool_.run(tasksOf(screened.size(), kRankedATask), seedTogether, poll_);
}

void RestartSearch::rankOthers(const SeedGrid& grid, const std::vector<ScreenedPlace>& screened,
                               std::vector<Ranked>& ranked) const {
  const std::size_t before = ranked.size();
  ranked.resize(before + screened.size());
  const auto rankTogether = [&](std::size_t task) {
    const std::size_t end = std::min(screened.size(), (task + 1) * kRankedATask);
    for (std::size_t i = task * kRankedATask; i < end; ++i) {
      Ranked& place = ranked[before + i];
      place.place = screened[i].place;
      const CellPlanes cells = screening_.cellsOf(place.place);
      const Alignment seed = grid.seed(screened[i].seed);
      const Climber climber(query_, cells, metric_, window_);
      place.alignment = climber.evaluate(seed.shift, seed.rotation);
      countEvaluations(climber);
      place.seeds.add(place.alignment);
    }
  };
  pool_.run(tasksOf(screened.size(), kRankedATask), rankTogether, poll_);
}

void RestartSearch::climb(const std::vector<Ranked*>& places) const {
  const auto climbTogether = [&](std::size_t task) {
    const std::size_t end = std::min(places.size(), (task + 1) * kClimbedATask);
    for (std::size_t i = task * kClimbedATask; i < end; ++i) {
      Ranked& place = *places[i];
      const CellPlanes cells = screening_.cellsOf(place.place);
      Climber climber(query_, cells, metric_, window_);
      place.summits = climbFromSeeds(climber, place.seeds);
      place.alignment = place.summits.front();
      countEvaluations(climber);
    }
  };
  pool_.run(tasksOf(places.size(), kClimbedATask), climbTogether, poll_);
}

void RestartSearch::refineSummits(const std::vector<Ranked*>& places) const {
  const auto refineOne = [&](std::size_t i) {
    const CellPlanes cells = screening_.cellsOf(places[i]->place);
    Climber climber(query_, cells, metric_, window_);
    places[i]->alignment = refine(climber, places[i]->summits);
    places[i]->refined = true;
    countEvaluations(climber);
  };
  pool_.run(places.size(), refineOne, poll_);
}

void RestartSearch::finish(std::vector<Ranked*>& ranked) const {
  const auto refined = static_cast<std::size_t>(kRefined * timesMany(kRefinedGrowthOfMany));
  for (std::size_t first = climbed();; first = std::max(kSurelyClimbed, refined)) {
    first = std::min(first, ranked.size());
    const auto end = ranked.begin() + static_cast<std::ptrdiff_t>(first);
    std::partial_sort(ranked.begin(), end, ranked.end(), isBetter);
    std::vector<Ranked*> to_climb, to_refine;
    for (std::size_t i = 0; i < first; ++i) {
      if (ranked[i]->summits.empty()) to_climb.push_back(ranked[i]);
      if (i < refined && !ranked[i]->refined) to_refine.push_back(ranked[i]);
    }
    if (to_climb.empty() && to_refine.empty()) break;
    if (to_climb.empty()) {
      refineSummits(to_refine);
    } else {
      climb(to_climb);
    }
  }
  std::sort(ranked.begin(), ranked.end(), isBetter);
  if (ranked.size() > kMostRanked) ranked.resize(kMostRanked);
}

}  // namespace place_memory::core
