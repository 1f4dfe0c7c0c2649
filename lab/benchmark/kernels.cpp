#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/kernels/block_kernel.h"
#include "core/match/lattice.h"
#include "core/match/query_planes.h"
#include "cycle_counter.h"
#include "setting.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

constexpr std::size_t kTransforms = 31;  // the rotations of a compass window, each at one shift

/// A block of places, and a query under several transforms, as a search has them in its cache.
struct KernelCase {
  core::PlaneBlock block;
  std::vector<core::QueryRow> query;
  std::vector<std::int64_t> offsets = std::vector<std::int64_t>(kTransforms);
};

KernelCase makeCase(Setting& setting) {
  KernelCase made;
  const auto& places = setting.simulated().places;
  for (std::size_t i = 0; i < core::kBlockPlaces; ++i) {
    made.block.set(i, core::CellPlanes(places[i].grid));
  }
  const core::QueryPlanes planes(setting.simulated().local.front().scan.grid, core::kHeadingStep,
                                 static_cast<int>(kTransforms / 2));
  for (int rotation = -planes.rotations(); rotation <= planes.rotations(); ++rotation) {
    for (std::size_t row = 0; row < core::kGridSize; ++row) {
      made.query.push_back({planes.at(rotation).occupied[row], planes.at(rotation).empty[row]});
    }
  }
  return made;
}

/// One iteration is one transform of one place. (The counts of unsensed cells follow from totals,
/// which are sums that a transform, or a place, has once.)
void evaluations(State& state, Setting& setting,
                 const core::KernelVariant<core::BlockKernel>& kernel) {
  const KernelCase made = makeCase(setting);
  const core::KernelInput input{made.block.rows.data(), made.query.data(),
                                core::kGridSize,        kTransforms,
                                {106, -53, -63, 19},    made.offsets.data()};
  std::array<core::BlockScores, kTransforms> scores{};
  const CycleCounter cycles(state);
  constexpr std::size_t kBatch = kTransforms * core::kBlockPlaces;
  while (state.KeepRunningBatch(kBatch)) {
    ::benchmark::DoNotOptimize(kernel.kernel(input, scores.data()));
    ::benchmark::ClobberMemory();
  }
}

}  // namespace

void registerKernels(Setting& setting) {
  for (const auto& kernel : core::blockKernels()) {
    const auto& sets = core::instructionSets();
    if (std::find(sets.begin(), sets.end(), kernel.set) == sets.end()) continue;
    ::benchmark::RegisterBenchmark(
        (std::string("evaluation/") + core::nameOf(kernel.set)).c_str(),
        [=, &setting](State& state) { evaluations(state, setting, kernel); });
  }
}

}  // namespace place_memory::measure
