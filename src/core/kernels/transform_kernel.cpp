#include "core/kernels/transform_kernel.h"

#include <algorithm>

namespace place_memory::core {
namespace {

/// One after the other.
void countEach(const CellPlanes& learned, const MovedPlanes* transforms, std::size_t size,
               PlaneCounts* counts) {
  for (std::size_t i = 0; i < size; ++i) {
    const CellPlanes& cells = *transforms[i].cells;
    const CellShift shift = transforms[i].shift;
    const int first = std::max(0, shift.rows);
    const int end = std::min(kGridSize, kGridSize + shift.rows);
    const int from = first - shift.rows;
    counts[i] = countPlanes({cells.occupied.data() + from, cells.empty.data() + from,
                             learned.occupied.data() + first, learned.empty.data() + first,
                             end - first, shift.columns});
  }
}

}  // namespace

std::vector<NamedTransformKernel> transformKernels() {
  std::vector<NamedTransformKernel> kernels{{"one by one", countEach, true}};
#if defined(__x86_64__)
  __builtin_cpu_init();
  kernels.push_back(
      {"avx512vpopcntdq", countTransformsAvx512, __builtin_cpu_supports("avx512vpopcntdq") != 0});
#endif
  return kernels;
}

TransformKernel fastestTransformKernel() {
  TransformKernel fastest = countEach;
  for (const NamedTransformKernel& named : transformKernels()) {
    if (named.runs_here) fastest = named.kernel;
  }
  return fastest;
}

}  // namespace place_memory::core
