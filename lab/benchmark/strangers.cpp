#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/match/alignment_search.h"
#include "setting.h"
#include "spliced_places.h"
#include "support/parallel_for.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

/// Strangers of each kind that each query is held to.
constexpr std::size_t kStrangers = 1000;
constexpr std::size_t kQueries = 100;

using Scores = std::vector<double>;  ///< [query * kStrangers + stranger]

/// What each query scores at best with each of the grids.
Scores scoresOf(const std::vector<const Query*>& queries,
                const std::vector<core::CellPlanes>& strangers, bool any_heading,
                const config::Parameters& parameters) {
  const double cell_size = core::kDefaultCellSize;
  const core::RecognizerOptions& options = parameters.match.recognizer;
  const core::SearchWindow window = core::searchWindow(
      options.position_window, any_heading ? core::kPi : parameters.match.recognizer.heading_window,
      cell_size);
  const core::LatticeMetric metric = core::onLattice(options.metric, window, cell_size);
  Scores scores(queries.size() * strangers.size());
  support::parallelFor(queries.size(), [&](std::size_t q) {
    const core::QueryPlanes query(queries[q]->scan.grid, core::kHeadingStep, window.rotations);
    for (std::size_t i = 0; i < strangers.size(); ++i) {
      scores[q * strangers.size() + i] =
          core::findAlignment(query, strangers[i], metric, window, options.method).score;
    }
  });
  return scores;
}

double quantile(Scores scores, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(scores.size() - 1));
  std::nth_element(scores.begin(), scores.begin() + rank, scores.end());
  return scores[static_cast<std::size_t>(rank)];
}

/// The best of the strangers, on the mean over the queries: what a right place has to beat.
double meanBest(const Scores& scores) {
  double sum = 0.0;
  int queries = 0;
  for (auto row = scores.begin(); row != scores.end(); row += kStrangers) {
    sum += *std::max_element(row, row + kStrangers);
    ++queries;
  }
  return sum / queries;
}

void note(State& state, const std::string& kind, const Scores& scores) {
  state.counters[kind + "_50"] = quantile(scores, 0.5);
  state.counters[kind + "_90"] = quantile(scores, 0.9);
  state.counters[kind + "_99"] = quantile(scores, 0.99);
  state.counters[kind + "_999"] = quantile(scores, 0.999);
  state.counters[kind + "_best_of_1000"] = meanBest(scores);
}

/// Simulated strangers, from buildings that no query is from, and spliced ones made of those.
void strangers(State& state, Setting& setting, bool any_heading) {
  const std::vector<KnownPlace>& places = setting.simulated().places;
  const std::size_t first_building = places.at(kQueryPlaces).building + 1;
  std::vector<core::CellPlanes> simulated, spliced;
  for (std::size_t i = places.size(); simulated.size() < kStrangers; --i) {
    simulated.emplace_back(places[i - 1].grid);
  }
  const SplicedPlaces splicer(places, first_building);
  for (std::size_t i = 0; i < kStrangers; ++i) spliced.emplace_back(splicer.make(i).grid);
  const auto queries = setting.memory(kQueryPlaces).queries(kQueries, any_heading);
  for ([[maybe_unused]] auto _ : state) {
    note(state, "simulated", scoresOf(queries, simulated, any_heading, setting.parameters()));
    note(state, "spliced", scoresOf(queries, spliced, any_heading, setting.parameters()));
  }
}

}  // namespace

void registerStrangers(Setting& setting) {
  if (setting.options().max_places < kSimulatedPlaces) return;
  for (const bool any_heading : {false, true}) {
    ::benchmark::RegisterBenchmark(
        any_heading ? "strangers/any" : "strangers/local",
        [=, &setting](State& state) { strangers(state, setting, any_heading); })
        ->Iterations(1)
        ->Unit(::benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace place_memory::measure
