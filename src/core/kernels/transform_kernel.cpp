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

std::vector<KernelVariant<TransformKernel>> transformKernels() {
  return {
    {InstructionSet::kPortable, countEach},
#if defined(__x86_64__)
        {InstructionSet::kAvx512, countTransformsAvx512},
#endif
  };
}

}  // namespace place_memory::core
