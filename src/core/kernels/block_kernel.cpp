#include "core/kernels/block_kernel.h"

#include "core/kernels/popcount.h"

namespace place_memory::core {
namespace {

/// One source for every processor that counts the bits of a word at a time.
template <typename Popcount>
[[gnu::always_inline]] inline std::int64_t scorePlace(const KernelInput& input,
                                                      const QueryRow* query, std::size_t place) {
  constexpr Popcount popcount{};
  std::uint64_t oo = 0, oe = 0, eo = 0, ee = 0;
  // A row is few instructions, and compilers leave a loop of unknown length as it is.
#pragma GCC unroll 4
  for (std::size_t row = 0; row < input.rows; ++row) {
    const std::uint64_t learned_o = input.places[row].occupied[place];
    const std::uint64_t learned_e = input.places[row].empty[place];
    oo += popcount(query[row].occupied & learned_o);
    oe += popcount(query[row].occupied & learned_e);
    eo += popcount(query[row].empty & learned_o);
    ee += popcount(query[row].empty & learned_e);
  }
  const PairFactors& factors = input.factors;
  return factors.occupied_occupied * static_cast<std::int64_t>(oo) +
         factors.occupied_empty * static_cast<std::int64_t>(oe) +
         factors.empty_occupied * static_cast<std::int64_t>(eo) +
         factors.empty_empty * static_cast<std::int64_t>(ee);
}

template <typename Popcount>
[[gnu::always_inline]] inline BlockBest scoreBlock(const KernelInput& input, BlockScores* scores) {
  for (std::size_t t = 0; t < input.transforms; ++t) {
    for (std::size_t place = 0; place < kBlockPlaces; ++place) {
      scores[t][place] =
          input.offsets[t] + scorePlace<Popcount>(input, input.query + t * input.rows, place);
    }
  }
  return bestOf(scores, input.transforms);
}

BlockBest scoreBlockPortable(const KernelInput& input, BlockScores* scores) {
  return scoreBlock<PortablePopcount>(input, scores);
}

}  // namespace

#if defined(__x86_64__)
[[gnu::target("popcnt")]] BlockBest scoreBlockPopcnt(const KernelInput& input,
                                                     BlockScores* scores) {
  return scoreBlock<BuiltinPopcount>(input, scores);
}
#endif

std::vector<KernelVariant<BlockKernel>> blockKernels() {
  return {
    {InstructionSet::kPortable, scoreBlockPortable},
#if defined(__x86_64__)
        {InstructionSet::kPopcnt, scoreBlockPopcnt}, {InstructionSet::kAvx2, scoreBlockAvx2},
        {InstructionSet::kAvx512, scoreBlockAvx512},
#elif defined(__aarch64__)
        {InstructionSet::kNeon, scoreBlockNeon},
#endif
  };
}

}  // namespace place_memory::core
