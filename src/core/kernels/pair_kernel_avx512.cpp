#include "core/kernels/pair_kernel.h"

#if defined(__x86_64__)

#include "core/kernels/avx512_counts.h"

namespace place_memory::core {
namespace {

using avx512::kAllLanes;
using avx512::kLanes;
using avx512::Sums;

/// Eight rows, of which the mask has those that count.
template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void addRows(const RowPairs& pairs, int row,
                                                                __mmask8 mask, __m128i by,
                                                                Sums& sums) {
  __m512i o = _mm512_maskz_loadu_epi64(mask, pairs.occupied + row);
  __m512i e = _mm512_maskz_loadu_epi64(mask, pairs.empty + row);
  o = kLeft ? _mm512_maskz_sll_epi64(kAllLanes, o, by) : _mm512_maskz_srl_epi64(kAllLanes, o, by);
  e = kLeft ? _mm512_maskz_sll_epi64(kAllLanes, e, by) : _mm512_maskz_srl_epi64(kAllLanes, e, by);
  const __m512i learned_o = _mm512_maskz_loadu_epi64(mask, pairs.learned_occupied + row);
  const __m512i learned_e = _mm512_maskz_loadu_epi64(mask, pairs.learned_empty + row);
  avx512::addRows(o, e, learned_o, learned_e, sums);
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
  return avx512::total(sums);
}

}  // namespace

[[PLACE_MEMORY_AVX512]] PlaneCounts countPlanesAvx512(const RowPairs& pairs) {
  return pairs.columns >= 0 ? countShifted<true>(pairs) : countShifted<false>(pairs);
}

}  // namespace place_memory::core

#endif
