#ifndef PLACE_MEMORY_CORE_KERNELS_POPCOUNT_H
#define PLACE_MEMORY_CORE_KERNELS_POPCOUNT_H

#include <cstdint>

namespace place_memory::core {

/// Counts set bits on any processor (H. S. Warren, Hacker's Delight, 5-1). The compiler's builtin
/// is a call of a library wherever the processor is not known to have an instruction for it.
struct PortablePopcount {
  [[gnu::always_inline]] std::uint64_t operator()(std::uint64_t word) const {
    word -= word >> 1U & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + (word >> 2U & 0x3333333333333333U);
    word = (word + (word >> 4U)) & 0x0f0f0f0f0f0f0f0fU;
    return word * 0x0101010101010101U >> 56U;
  }
};

/// Counts set bits in functions compiled for processors that can.
struct BuiltinPopcount {
  [[gnu::always_inline]] std::uint64_t operator()(std::uint64_t word) const {
    return static_cast<std::uint64_t>(__builtin_popcountll(word));
  }
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_POPCOUNT_H
