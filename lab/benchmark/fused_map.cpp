#include "core/mapping/fused_map.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "setting.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

constexpr std::size_t kSizes[] = {1000, 10000};
constexpr double kSpacing = 5.0 * 0.3048;  // of places, the paper's (7) [m]
constexpr std::size_t kMostGrids = 500;    // different ones
constexpr double kStep = 0.1;              // by which a place is moved [m]

/// Places side by side in a square, as they are in a building that is all corridors and rooms.
class SquareOfPlaces {
 public:
  SquareOfPlaces(const SimulatedPlaces& simulated, std::size_t size) : size_(size) {
    const std::size_t grids = std::min(simulated.places.size(), kMostGrids);
    for (std::size_t i = 0; i < grids; ++i) {
      grids_.push_back(std::make_shared<const core::EvidenceGrid>(simulated.places[i].grid));
    }
  }

  core::FusedMap map() const {
    core::FusedMap map({}, core::GridGeometry{});
    for (std::size_t i = 0; i < size_; ++i) map.add(place(i), grids_[i % grids_.size()]);
    map.update();
    return map;
  }

  core::Place place(std::size_t index) const {
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(size_))));
    core::Place place;
    place.id = static_cast<core::PlaceId>(index) + 1;
    place.map_from_place = {kSpacing * static_cast<double>(index % side),
                            kSpacing * static_cast<double>(index / side),
                            0.7 * static_cast<double>(index)};
    return place;
  }

 private:
  std::size_t size_;
  std::vector<std::shared_ptr<const core::EvidenceGrid>> grids_;
};

/// The whole map, from its places.
void scratch(State& state, Setting& setting, std::size_t size) {
  const SquareOfPlaces places(setting.simulated(), size);
  std::size_t cells = 0;
  for ([[maybe_unused]] auto _ : state) {
    const core::FusedMap map = places.map();
    state.PauseTiming();
    cells = map.cells().evidence.size();
    state.ResumeTiming();
  }
  state.counters["cells"] = static_cast<double>(cells);
}

/// One place moves, and the map follows.
void moved(State& state, Setting& setting, std::size_t size) {
  const SquareOfPlaces places(setting.simulated(), size);
  core::FusedMap map = places.map();
  std::size_t next = 0;
  double step = kStep;
  for ([[maybe_unused]] auto _ : state) {
    const core::Place place = places.place(next);
    core::MapChange change;
    change.edits.emplace_back(core::PlaceMoved{
        place.id, place.map_from_place * core::Pose2d{step, 0.0, 0.0}, place.session});
    map.apply(change);
    map.update();
    next = (next + 37) % size;
    step = -step;
  }
}

/// The map as it is published, out of its tiles.
void cells(State& state, Setting& setting, std::size_t size) {
  const core::FusedMap map = SquareOfPlaces(setting.simulated(), size).map();
  for ([[maybe_unused]] auto _ : state) ::benchmark::DoNotOptimize(map.cells().evidence.data());
}

}  // namespace

void registerFusedMap(Setting& setting) {
  using ::benchmark::RegisterBenchmark;
  std::set<std::size_t> sizes;
  for (const std::size_t size : kSizes) sizes.insert(std::min(size, setting.options().max_places));
  for (const std::size_t size : sizes) {
    const std::string places = std::to_string(size);
    RegisterBenchmark(("fused_map/scratch/" + places).c_str(),
                      [=, &setting](State& state) { scratch(state, setting, size); })
        ->Iterations(1)
        ->Unit(::benchmark::kMillisecond);
    RegisterBenchmark(("fused_map/moved/" + places).c_str(), [=, &setting](State& state) {
      moved(state, setting, size);
    })->Unit(::benchmark::kMicrosecond);
    RegisterBenchmark(("fused_map/cells/" + places).c_str(), [=, &setting](State& state) {
      cells(state, setting, size);
    })->Unit(::benchmark::kMillisecond);
  }
}

}  // namespace place_memory::measure
