#include <benchmark/benchmark.h>

#include "core/match/alignment_search.h"
#include "cycle_counter.h"
#include "place_memory/core/sonar_model.h"
#include "setting.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

/// One transform of one place, as a search of a few transforms has it.
void onePair(State& state, Setting& setting) {
  const SyntheticMemory memory =
      setting.memory(std::min<std::size_t>(47, setting.options().max_places));
  const Query& query = *memory.queries(1, false).front();
  const core::SearchWindow window = core::searchWindow(
      setting.parameters().match.recognizer.position_window,
      setting.parameters().match.recognizer.heading_window, query.scan.grid.geometry().cell_size);
  const core::LatticeMetric metric = core::onLattice(setting.parameters().match.recognizer.metric,
                                                     window, query.scan.grid.geometry().cell_size);
  const core::QueryPlanes planes(query.scan.grid, core::kHeadingStep, window.rotations);
  const core::CellPlanes place(setting.simulated().places.front().grid);
  const CycleCounter cycles(state);
  int shift = -window.cells;
  for ([[maybe_unused]] auto _ : state) {
    ::benchmark::DoNotOptimize(core::scoreAt(planes, place, metric, {shift, -shift}, shift));
    if (++shift > window.cells) shift = -window.cells;
  }
}

void preparation(State& state, Setting& setting, bool any_heading) {
  const SyntheticMemory memory =
      setting.memory(std::min<std::size_t>(47, setting.options().max_places));
  const Query& query = *memory.queries(1, any_heading).front();
  const double heading =
      any_heading ? core::kPi : setting.parameters().match.recognizer.heading_window;
  const core::SearchWindow window =
      core::searchWindow(setting.parameters().match.recognizer.position_window, heading,
                         query.scan.grid.geometry().cell_size);
  for ([[maybe_unused]] auto _ : state) {
    const core::QueryPlanes planes(query.scan.grid, core::kHeadingStep, window.rotations);
    ::benchmark::DoNotOptimize(&planes);
  }
}

/// A scan's readings made into a grid.
void gridBuilding(State& state, Setting& setting) {
  const SyntheticMemory memory =
      setting.memory(std::min<std::size_t>(47, setting.options().max_places));
  const auto queries = memory.queries(16, false);
  const core::SonarModel sonar(setting.parameters().sonar);
  std::size_t next = 0;
  double readings = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const core::Scan& scan = queries[next++ % queries.size()]->scan;
    const core::EvidenceGrid grid = sonar.build(scan.readings, scan.grid.geometry());
    ::benchmark::DoNotOptimize(grid.cells().data());
    readings += static_cast<double>(scan.readings.size());
  }
  state.counters["readings"] = readings / static_cast<double>(next);
}

}  // namespace

void registerParts(Setting& setting) {
  using ::benchmark::RegisterBenchmark;
  RegisterBenchmark("evaluation/one", [&](State& state) { onePair(state, setting); });
  RegisterBenchmark("preparation/local", [&](State& state) {
    preparation(state, setting, false);
  })->Unit(::benchmark::kMicrosecond);
  RegisterBenchmark("preparation/any", [&](State& state) {
    preparation(state, setting, true);
  })->Unit(::benchmark::kMicrosecond);
  RegisterBenchmark("grid", [&](State& state) {
    gridBuilding(state, setting);
  })->Unit(::benchmark::kMicrosecond);
}

}  // namespace place_memory::measure
