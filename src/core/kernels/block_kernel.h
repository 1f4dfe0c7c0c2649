#ifndef PLACE_MEMORY_CORE_KERNELS_BLOCK_KERNEL_H
#define PLACE_MEMORY_CORE_KERNELS_BLOCK_KERNEL_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kernels/cpu.h"
#include "core/kernels/plane_block.h"

namespace place_memory::core {

/// A row of a recognition grid under some transform, the same for all places.
struct QueryRow {
  std::uint64_t occupied = 0;
  std::uint64_t empty = 0;
};

/// Points for a pair of a sensed recognition cell (named first) and a sensed learned one, in fixed
/// point.
struct PairFactors {
  std::int32_t occupied_occupied, occupied_empty;
  std::int32_t empty_occupied, empty_empty;
};

/// Of each place of a block, for one transform.
using BlockScores = std::array<std::int64_t, kBlockPlaces>;

/// What a kernel works on.
struct KernelInput {
  const BlockRow* places;  ///< `rows` of them
  const QueryRow* query;   ///< `rows` of them for each transform, one transform after the other
  std::size_t rows;        ///< a multiple of 4, at most kGridSize
  std::size_t transforms;
  PairFactors factors;
  const std::int64_t* offsets;  ///< of each transform, in the same fixed point
};

/// The best of all transforms for each place of a block; of equal ones the first.
struct BlockBest {
  BlockScores score;
  std::array<std::int64_t, kBlockPlaces> transform;
};

/// Sets scores[t] to the points of all pairs of transform t with each place, and its offset. At
/// least one transform.
using BlockKernel = BlockBest (*)(const KernelInput& input, BlockScores* scores);

/// Those compiled for this architecture, slowest first.
std::vector<KernelVariant<BlockKernel>> blockKernels();

/// The best of what a kernel set, for kernels that do not find it on their way.
[[gnu::always_inline]] inline BlockBest bestOf(const BlockScores* scores, std::size_t transforms) {
  BlockBest best{scores[0], {}};
  for (std::size_t t = 1; t < transforms; ++t) {
    for (std::size_t place = 0; place < kBlockPlaces; ++place) {
      const bool better = scores[t][place] > best.score[place];
      best.score[place] = better ? scores[t][place] : best.score[place];
      best.transform[place] = better ? static_cast<std::int64_t>(t) : best.transform[place];
    }
  }
  return best;
}

#if defined(__x86_64__)
BlockBest scoreBlockPopcnt(const KernelInput& input, BlockScores* scores);
BlockBest scoreBlockAvx2(const KernelInput& input, BlockScores* scores);
BlockBest scoreBlockAvx512(const KernelInput& input, BlockScores* scores);
#elif defined(__aarch64__)
BlockBest scoreBlockNeon(const KernelInput& input, BlockScores* scores);
#endif

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_BLOCK_KERNEL_H
