#include "core/kernels/pair_kernel.h"

#include "core/kernels/popcount.h"

namespace place_memory::core {
namespace {

template <bool kLeft, typename Popcount>
[[gnu::always_inline]] inline PlaneCounts countRows(const RowPairs& pairs) {
  constexpr Popcount popcount{};
  PlaneCounts n{};
  const int by = kLeft ? pairs.columns : -pairs.columns;
  for (int row = 0; row < pairs.rows; ++row) {
    const std::uint64_t o = kLeft ? pairs.occupied[row] << by : pairs.occupied[row] >> by;
    const std::uint64_t e = kLeft ? pairs.empty[row] << by : pairs.empty[row] >> by;
    const std::uint64_t learned_o = pairs.learned_occupied[row];
    const std::uint64_t learned_e = pairs.learned_empty[row];
    n.occupied += popcount(o);
    n.empty += popcount(e);
    n.occupied_occupied += popcount(o & learned_o);
    n.occupied_empty += popcount(o & learned_e);
    n.empty_occupied += popcount(e & learned_o);
    n.empty_empty += popcount(e & learned_e);
  }
  return n;
}

template <typename Popcount>
[[gnu::always_inline]] inline PlaneCounts countBody(const RowPairs& pairs) {
  return pairs.columns >= 0 ? countRows<true, Popcount>(pairs) : countRows<false, Popcount>(pairs);
}

PlaneCounts countPortable(const RowPairs& pairs) { return countBody<PortablePopcount>(pairs); }

#if defined(__x86_64__)
[[gnu::target("popcnt")]] PlaneCounts countPopcnt(const RowPairs& pairs) {
  return countBody<BuiltinPopcount>(pairs);
}

#endif

}  // namespace

std::vector<KernelVariant<PairKernel>> pairKernels() {
  return {
    {InstructionSet::kPortable, countPortable},
#if defined(__x86_64__)
        {InstructionSet::kPopcnt, countPopcnt}, {InstructionSet::kAvx512, countPlanesAvx512},
#endif
  };
}

PlaneCounts countPlanes(const RowPairs& pairs) {
  static const PairKernel kernel = chosenKernel(pairKernels());
  return kernel(pairs);
}

}  // namespace place_memory::core
