#include "core/kernels/pair_kernel.h"

namespace place_memory::core {
namespace {

std::uint64_t popcount(std::uint64_t word) {
  return static_cast<std::uint64_t>(__builtin_popcountll(word));
}

template <bool kLeft>
[[gnu::always_inline]] inline PlaneCounts countRows(const RowPairs& pairs) {
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

[[gnu::always_inline]] inline PlaneCounts countBody(const RowPairs& pairs) {
  return pairs.columns >= 0 ? countRows<true>(pairs) : countRows<false>(pairs);
}

PlaneCounts countPortable(const RowPairs& pairs) { return countBody(pairs); }

#if defined(__x86_64__)
[[gnu::target("popcnt")]] PlaneCounts countPopcnt(const RowPairs& pairs) {
  return countBody(pairs);
}

#endif

using Kernel = PlaneCounts (*)(const RowPairs&);

Kernel fastestKernel() {
  Kernel fastest = countPortable;
  for (const NamedPairKernel& named : pairKernels()) {
    if (named.runs_here) fastest = named.kernel;
  }
  return fastest;
}

}  // namespace

std::vector<NamedPairKernel> pairKernels() {
  std::vector<NamedPairKernel> kernels{{"portable", countPortable, true}};
#if defined(__x86_64__)
  __builtin_cpu_init();
  kernels.push_back({"popcnt", countPopcnt, __builtin_cpu_supports("popcnt") != 0});
  kernels.push_back(
      {"avx512vpopcntdq", countPlanesAvx512, __builtin_cpu_supports("avx512vpopcntdq") != 0});
#endif
  return kernels;
}

PlaneCounts countPlanes(const RowPairs& pairs) {
  static const Kernel kernel = fastestKernel();
  return kernel(pairs);
}

}  // namespace place_memory::core
