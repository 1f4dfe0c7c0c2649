#ifndef PLACE_MEMORY_CORE_KERNELS_PAIR_KERNEL_H
#define PLACE_MEMORY_CORE_KERNELS_PAIR_KERNEL_H

#include <cstdint>
#include <vector>

#include "core/kernels/cpu.h"

namespace place_memory::core {

/// Rows of the planes that two grids share, the recognition grid's before it is shifted.
struct RowPairs {
  const std::uint64_t* occupied;
  const std::uint64_t* empty;
  const std::uint64_t* learned_occupied;
  const std::uint64_t* learned_empty;
  int rows;
  int columns;  ///< shift along x, in [-63, 63]
};

/// Cells set in the recognition grid's shifted planes, and in their intersections with the learned
/// ones.
struct PlaneCounts {
  std::uint64_t occupied, empty;
  std::uint64_t occupied_occupied, occupied_empty;
  std::uint64_t empty_occupied, empty_empty;
};

/// The same counts on every machine; as fast as its vector unit allows.
PlaneCounts countPlanes(const RowPairs& pairs);

using PairKernel = PlaneCounts (*)(const RowPairs& pairs);

/// Those compiled for this architecture, slowest first.
std::vector<KernelVariant<PairKernel>> pairKernels();

#if defined(__x86_64__)
PlaneCounts countPlanesAvx512(const RowPairs& pairs);
#endif

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_PAIR_KERNEL_H
