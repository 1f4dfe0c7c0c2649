#ifndef PLACE_MEMORY_CORE_KERNELS_TRANSFORM_KERNEL_H
#define PLACE_MEMORY_CORE_KERNELS_TRANSFORM_KERNEL_H

#include <cstddef>
#include <vector>

#include "core/grid/cell_planes.h"
#include "core/grid/cell_shift.h"
#include "core/kernels/cpu.h"
#include "core/kernels/pair_kernel.h"

namespace place_memory::core {

/// A rotated recognition grid, and how it is shifted: in [-63, 63] along both axes.
struct MovedPlanes {
  const CellPlanes* cells;
  CellShift shift;
};

/// Sets counts[i] to what the recognition grid under transform i and one learned grid share.
using TransformKernel = void (*)(const CellPlanes& learned, const MovedPlanes* transforms,
                                 std::size_t size, PlaneCounts* counts);

/// Those compiled for this architecture, slowest first.
std::vector<KernelVariant<TransformKernel>> transformKernels();

#if defined(__x86_64__)
void countTransformsAvx512(const CellPlanes& learned, const MovedPlanes* transforms,
                           std::size_t size, PlaneCounts* counts);
#endif

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_TRANSFORM_KERNEL_H
