#ifndef PLACE_MEMORY_CORE_KERNELS_AVX512_COUNTS_H
#define PLACE_MEMORY_CORE_KERNELS_AVX512_COUNTS_H

#include <immintrin.h>

#include <cstdint>

#include "core/kernels/pair_kernel.h"

#define PLACE_MEMORY_AVX512 gnu::target("avx512f,avx512vpopcntdq")

/// What kernels share that hold rows of one place in the lanes of a vector.
namespace place_memory::core::avx512 {

constexpr int kLanes = 8;             ///< rows in a vector
constexpr unsigned kFieldBits = 16;   ///< a count is at most 4096
constexpr __mmask8 kAllLanes = 0xff;  // GCC takes forms without a mask for uninitialized

/// Cells of both grids, by lane.
struct Sums {
  __m512i o, e, oo, oe, eo, ee;
};

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i countBits(__m512i sum, __m512i bits) {
  return _mm512_add_epi64(sum, _mm512_popcnt_epi64(bits));
}

/// Rows of the recognition grid (o, e) and of the learned one.
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void addRows(__m512i o, __m512i e,
                                                                __m512i learned_o,
                                                                __m512i learned_e, Sums& sums) {
  sums.o = countBits(sums.o, o);
  sums.e = countBits(sums.e, e);
  sums.oo = countBits(sums.oo, _mm512_and_si512(o, learned_o));
  sums.oe = countBits(sums.oe, _mm512_and_si512(o, learned_e));
  sums.eo = countBits(sums.eo, _mm512_and_si512(e, learned_o));
  sums.ee = countBits(sums.ee, _mm512_and_si512(e, learned_e));
}

/// Several counts side by side in the fields of a lane, so that they are summed over lanes at once.
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i packed(__m512i low, __m512i high,
                                                                  unsigned fields) {
  return _mm512_add_epi64(low, _mm512_maskz_slli_epi64(kAllLanes, high, fields * kFieldBits));
}

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline std::uint64_t overLanes(__m512i sums) {
  std::uint64_t lanes[kLanes];
  _mm512_storeu_si512(lanes, sums);
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline PlaneCounts total(const Sums& sums) {
  const std::uint64_t both =
      overLanes(packed(packed(sums.oo, sums.oe, 1), packed(sums.eo, sums.ee, 1), 2));
  const std::uint64_t own = overLanes(packed(sums.o, sums.e, 1));
  constexpr std::uint64_t kField = (1U << kFieldBits) - 1U;
  return {own & kField,
          own >> kFieldBits,
          both & kField,
          both >> kFieldBits & kField,
          both >> (2 * kFieldBits) & kField,
          both >> (3 * kFieldBits)};
}

}  // namespace place_memory::core::avx512

#endif  // PLACE_MEMORY_CORE_KERNELS_AVX512_COUNTS_H
