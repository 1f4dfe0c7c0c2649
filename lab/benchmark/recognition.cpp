#include <benchmark/benchmark.h>

#include <map>

#include "core/match/place_search.h"
#include "core/recognize/recognizer.h"
#include "full_search.h"
#include "setting.h"
#include "yardstick.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

constexpr std::size_t kSizes[] = {21, 47, 1000, 10000, 100000, 1000000};

/// Largest memory that the yardstick is held to.
constexpr std::size_t kMaxYardstick = 1000;

/// Queries that evaluations are counted of: their number hardly differs from one to the next.
constexpr std::size_t kCounted = 10;

/// Up to so many places, recognition is repeated: a run of milliseconds says little.
constexpr std::size_t kSmall = 1000;
/// The yardstick takes longer; so often, in memories smaller than that.
constexpr int kTimesYardstick = 3;

/// Seconds for a place that queries are planned with; they need to be right within a factor of ten.
constexpr double kSecondsLocal = 1e-6;
constexpr double kSecondsYardstick = 5e-4;
constexpr double kSecondsFull = 2e-6;
constexpr double kMoreForAnyHeading = 4.0;

double headingWindow(const Setting& setting, bool any_heading) {
  return any_heading ? core::kPi : setting.parameters().match.recognizer.heading_window;
}

double share(int part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

/// What the search of these queries takes, a place: not timed.
double evaluationsPerPlace(const core::RecognizerOptions& options, const core::PlaceIndex& index,
                           const std::vector<const Query*>& queries, double heading_window) {
  const core::SearchWindow window =
      core::searchWindow(options.position_window, heading_window, core::kDefaultCellSize);
  const core::LatticeMetric metric =
      core::onLattice(options.metric, window, core::kDefaultCellSize);
  double evaluations = 0.0;
  const std::size_t counted = std::min(queries.size(), kCounted);
  for (std::size_t i = 0; i < counted; ++i) {
    const core::QueryPlanes planes(queries[i]->scan.grid, core::kHeadingStep, window.rotations);
    core::SearchEffort effort;
    core::searchPlaces(planes, index, metric, window, options.method, nullptr,
                       support::WorkerPool::shared(), &effort);
    evaluations += effort.evaluations;
  }
  return evaluations / static_cast<double>(counted * index.size());
}

/// One iteration is one scan that is recognized, prepared planes and all.
void recognition(State& state, Setting& setting, std::size_t size, bool any_heading) {
  const core::Recognizer recognizer(setting.parameters().match.recognizer);
  const SyntheticMemory memory = setting.memory(size);
  const KnownMap& map = setting.map(size);
  const auto queries = memory.queries(static_cast<std::size_t>(state.max_iterations), any_heading);
  const double window = headingWindow(setting, any_heading);
  int right = 0, recognized = 0, wrongly = 0;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Query& query = *queries[next++ % queries.size()];
    const core::Recognition answer =
        recognizer.recognize(query.scan, map.index, map.lookUp(), window).value();
    const bool is_right = memory.isRight(query, answer.matches.front().id);
    right += is_right ? 1 : 0;
    if (answer.verdict != core::Verdict::kRecognized) continue;
    recognized += is_right ? 1 : 0;
    wrongly += is_right ? 0 : 1;
  }
  state.counters["queries"] = static_cast<double>(queries.size());
  state.counters["top1"] = share(right, next);
  state.counters["recognized"] = share(recognized, next);
  state.counters["sure_and_wrong"] = share(wrongly, next);
  state.counters["evaluations_per_place"] =
      evaluationsPerPlace(setting.parameters().match.recognizer, map.index, queries, window);
  state.counters["places"] = static_cast<double>(size);
}

/// One iteration is one scan that is held to every place at every transform; counted is how often
/// the default method finds the same best place, and the same score.
void fullSearch(State& state, Setting& setting, std::size_t size, bool any_heading) {
  const core::RecognizerOptions& options = setting.parameters().match.recognizer;
  const SyntheticMemory memory = setting.memory(size);
  const core::PlaceIndex& index = setting.index(size);
  const auto queries = memory.queries(static_cast<std::size_t>(state.max_iterations), any_heading);
  const core::SearchWindow window = core::searchWindow(
      options.position_window, headingWindow(setting, any_heading), core::kDefaultCellSize);
  const core::LatticeMetric metric =
      core::onLattice(options.metric, window, core::kDefaultCellSize);
  int right = 0, agree = 0, same_score = 0;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Query& query = *queries[next++ % queries.size()];
    const core::QueryPlanes planes(query.scan.grid, core::kHeadingStep, window.rotations);
    const core::PlaceAlignment found =
        core::searchPlaces(planes, index, metric, window, options.method, nullptr,
                           support::WorkerPool::shared())
            .front();
    const ScoredPlace known{found.place, found.alignment.score};
    const ScoredPlace best = FullSearch(planes, metric, window).best(index, known);
    agree += known.id == best.id ? 1 : 0;
    same_score += known.score >= best.score ? 1 : 0;
    right += memory.isRight(query, best.id) ? 1 : 0;
  }
  state.counters["queries"] = static_cast<double>(queries.size());
  state.counters["top1"] = share(right, next);
  state.counters["agree"] = share(agree, next);
  state.counters["same_score"] = share(same_score, next);
  state.counters["places"] = static_cast<double>(size);
}

void yardstick(State& state, Setting& setting, std::size_t size, bool any_heading) {
  const SyntheticMemory memory = setting.memory(size);
  std::vector<CellClasses> places;
  memory.forEach([&places](core::PlaceId, const KnownPlace& place) {
    places.push_back(classesOf(place.grid));
  });
  const auto queries = memory.queries(static_cast<std::size_t>(state.max_iterations), any_heading);
  int right = 0;
  double evaluations = 0.0;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Query& query = *queries[next++ % queries.size()];
    const CellClasses scan = classesOf(query.scan.grid);
    YardstickMatch best;
    core::PlaceId best_id = core::kNoPlace;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const YardstickMatch match =
          climbByCells(scan, places[i], query.scan.grid.geometry().cell_size, any_heading);
      evaluations += match.evaluations;
      if (best_id != core::kNoPlace && match.score <= best.score) continue;
      best = match;
      best_id = static_cast<core::PlaceId>(i + 1);
    }
    right += memory.isRight(query, best_id) ? 1 : 0;
  }
  state.counters["queries"] = static_cast<double>(queries.size());
  state.counters["top1"] = share(right, next);
  state.counters["places"] = static_cast<double>(size);
  state.counters["evaluations_per_place"] =
      evaluations / (static_cast<double>(next) * static_cast<double>(size));
}

using Run = void (*)(State&, Setting&, std::size_t, bool);

void add(const std::string& name, Run run, Setting& setting, std::size_t size, bool any_heading,
         double seconds_per_place, int times) {
  const double seconds = seconds_per_place * (any_heading ? kMoreForAnyHeading : 1.0);
  const std::size_t affordable = setting.affordableQueries(size, seconds);
  // Each query is put once, so that shares are over as many as there are.
  const std::size_t queries = std::min(affordable, size);
  auto* const added = ::benchmark::RegisterBenchmark(
      benchmarkName(name, any_heading, size).c_str(),
      [=, &setting](State& state) { run(state, setting, size, any_heading); });
  added->Iterations(static_cast<::benchmark::IterationCount>(queries))
      ->Unit(::benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
  if (times > 1) added->Repetitions(times)->ReportAggregatesOnly(true);
}

}  // namespace

void registerRecognition(Setting& setting) {
  for (const std::size_t size : kSizes) {
    if (size > setting.options().max_places) continue;
    for (const bool any_heading : {false, true}) {
      if (size <= kMaxYardstick) {
        add("yardstick", yardstick, setting, size, any_heading, kSecondsYardstick,
            size < kSmall ? kTimesYardstick : 1);
      }
      add("recognition", recognition, setting, size, any_heading, kSecondsLocal,
          size <= kSmall ? setting.options().times : 1);
      if (size <= setting.options().max_full) {
        add("full_search", fullSearch, setting, size, any_heading, kSecondsFull, 1);
      }
    }
  }
}

}  // namespace place_memory::measure
