#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>

#include "core/store/place_store.h"
#include "place_memory/core/place_memory.h"
#include "resident.h"
#include "setting.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;
namespace fs = std::filesystem;

constexpr std::size_t kSizes[] = {1000, 10000, 100000, 1000000};

class StoreFile {
 public:
  StoreFile(const std::string& folder, const SyntheticMemory& memory)
      : path_((fs::path(folder) / "place_memory_benchmark.db").string()) {
    fs::remove(path_);
    writeStore(path_, memory);
  }
  ~StoreFile() { fs::remove(path_); }
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// One iteration is one start with a store that is there: open, check, read, make ready to match.
void load(State& state, Setting& setting, std::size_t size) {
  const auto begin = std::chrono::steady_clock::now();
  const StoreFile file(setting.options().folder, setting.memory(size));
  const std::chrono::duration<double> writing = std::chrono::steady_clock::now() - begin;
  core::PlaceMemoryOptions options;
  options.store_path = file.path();
  options.recognizer = setting.parameters().match.recognizer;
  double resident = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const double before = residentBytes();
    state.ResumeTiming();
    const core::PlaceMemory memory(options);
    state.PauseTiming();
    resident = residentBytes() - before;
    if (memory.size() != size) state.SkipWithError("places are missing");
    state.ResumeTiming();
  }
  const auto places = static_cast<double>(size);
  state.counters["places"] = places;
  state.counters["resident_per_place"] = resident / places;
  state.counters["file_per_place"] = static_cast<double>(fs::file_size(file.path())) / places;
  state.counters["writing_seconds"] = writing.count();
}

/// What matching alone needs; and what making it from grids takes.
void index(State& state, Setting& setting, std::size_t size) {
  setting.dropMap();
  setting.simulated();
  double resident = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const double before = residentBytes();
    const core::PlaceIndex index = setting.memory(size).map().index;
    resident = residentBytes() - before;
  }
  state.counters["places"] = static_cast<double>(size);
  state.counters["resident_per_place"] = resident / static_cast<double>(size);
}

}  // namespace

void writeStore(const std::string& path, const SyntheticMemory& memory) {
  constexpr std::size_t kEditsAtOnce = 8192;  // some megabytes of grids
  core::PlaceStore store(path, core::kDefaultCellSize);
  core::MapChange change;
  const auto commit = [&] {
    ++change.version;
    store.commit(change);
    change.edits.clear();
  };
  core::PlaceId previous = core::kNoPlace;
  memory.forEach([&](core::PlaceId id, const KnownPlace& known) {
    core::Place place;
    place.id = id;
    place.label = "place " + std::to_string(id);
    place.map_from_place = known.map_from_place;
    change.edits.emplace_back(
        core::PlaceAdded{place, std::make_shared<core::EvidenceGrid>(known.grid), nullptr});
    core::PlaceLink link;
    link.first = previous;
    link.second = id;
    if (previous != core::kNoPlace) change.edits.emplace_back(core::LinkAdded{link});
    previous = id;
    if (change.edits.size() >= kEditsAtOnce) commit();
  });
  commit();
}

void registerMemory(Setting& setting) {
  // The largest first: in a heap that others have left full of holes an index takes more.
  for (auto size = std::rbegin(kSizes); size != std::rend(kSizes); ++size) {
    if (*size > setting.options().max_places) continue;
    ::benchmark::RegisterBenchmark(
        ("index/" + std::to_string(*size)).c_str(),
        [&setting, size = *size](State& state) { index(state, setting, size); })
        ->Iterations(1)
        ->Unit(::benchmark::kMillisecond)
        ->UseRealTime();
  }
}

void registerStore(Setting& setting) {
  for (const std::size_t size : kSizes) {
    if (size > setting.options().max_stored) continue;
    ::benchmark::RegisterBenchmark(("store/" + std::to_string(size)).c_str(),
                                   [=, &setting](State& state) { load(state, setting, size); })
        ->Iterations(3)
        ->Unit(::benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace place_memory::measure
