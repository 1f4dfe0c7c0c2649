#include "pair_kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define PLACE_MEMORY_AVX512 gnu::target("avx512f,avx512vpopcntdq")

namespace place_memory::core {
namespace {

constexpr int kLanes = 8;            ///< rows in a vector
constexpr unsigned kFieldBits = 16;  ///< a count is at most 4096

struct Sums {
  __m512i o, e, oo, oe, eo, ee;
};

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i countBits(__m512i sum, __m512i bits) {
  return _mm512_add_epi64(sum, _mm512_popcnt_epi64(bits));
}

/// Eight rows, of which the mask has those that count.
template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void addRows(const RowPairs& pairs, int row,
                                                                __mmask8 mask, __m128i by,
                                                                Sums& sums) {
  __m512i o = _mm512_maskz_loadu_epi64(mask, pairs.occupied + row);
  __m512i e = _mm512_maskz_loadu_epi64(mask, pairs.empty + row);
  constexpr __mmask8 kAllLanes = 0xff;  // GCC takes the form without a mask for uninitialized
  o = kLeft ? _mm512_maskz_sll_epi64(kAllLanes, o, by) : _mm512_maskz_srl_epi64(kAllLanes, o, by);
  e = kLeft ? _mm512_maskz_sll_epi64(kAllLanes, e, by) : _mm512_maskz_srl_epi64(kAllLanes, e, by);
  const __m512i learned_o = _mm512_maskz_loadu_epi64(mask, pairs.learned_occupied + row);
  const __m512i learned_e = _mm512_maskz_loadu_epi64(mask, pairs.learned_empty + row);
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
  constexpr __mmask8 kAllLanes = 0xff;
  return _mm512_add_epi64(low, _mm512_maskz_slli_epi64(kAllLanes, high, fields * kFieldBits));
}

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline std::uint64_t overLanes(__m512i sums) {
  std::uint64_t lanes[kLanes];
  _mm512_storeu_si512(lanes, sums);
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline PlaneCounts countShifted(const RowPairs& pairs) {
  const __m512i zero = _mm512_setzero_si512();
  const __m128i by = _mm_cvtsi32_si128(kLeft ? pairs.columns : -pairs.columns);
  Sums sums{zero, zero, zero, zero, zero, zero};
  int row = 0;
  for (; row + kLanes <= pairs.rows; row += kLanes) addRows<kLeft>(pairs, row, 0xff, by, sums);
  if (row < pairs.rows) {
    addRows<kLeft>(pairs, row, static_cast<__mmask8>((1U << (pairs.rows - row)) - 1U), by, sums);
  }
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

}  // namespace

[[PLACE_MEMORY_AVX512]] PlaneCounts countPlanesAvx512(const RowPairs& pairs) {
  return pairs.columns >= 0 ? countShifted<true>(pairs) : countShifted<false>(pairs);
}

}  // namespace place_memory::core

#endif
