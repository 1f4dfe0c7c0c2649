#include "core/kernels/block_kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <limits>

#include "core/kernels/avx512_counts.h"

namespace place_memory::core {
namespace {

/// Pairs of one transform, eight places side by side.
struct Counts {
  __m512i oo, oe, eo, ee;
};

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void count(__m512i learned_o, __m512i learned_e,
                                                              const QueryRow& row, Counts& n) {
  const __m512i o = _mm512_set1_epi64(static_cast<long long>(row.occupied));
  const __m512i e = _mm512_set1_epi64(static_cast<long long>(row.empty));
  n.oo = _mm512_add_epi64(n.oo, _mm512_popcnt_epi64(_mm512_and_si512(o, learned_o)));
  n.oe = _mm512_add_epi64(n.oe, _mm512_popcnt_epi64(_mm512_and_si512(o, learned_e)));
  n.eo = _mm512_add_epi64(n.eo, _mm512_popcnt_epi64(_mm512_and_si512(e, learned_o)));
  n.ee = _mm512_add_epi64(n.ee, _mm512_popcnt_epi64(_mm512_and_si512(e, learned_e)));
}

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i points(__m512i counts,
                                                                  std::int32_t factor) {
  return _mm512_maskz_mul_epi32(avx512::kAllLanes, counts, _mm512_set1_epi64(factor));
}

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i sum(const Counts& n,
                                                               const PairFactors& factors,
                                                               std::int64_t offset) {
  const __m512i o = _mm512_add_epi64(points(n.oo, factors.occupied_occupied),
                                     points(n.oe, factors.occupied_empty));
  const __m512i e =
      _mm512_add_epi64(points(n.eo, factors.empty_occupied), points(n.ee, factors.empty_empty));
  return _mm512_add_epi64(_mm512_set1_epi64(offset), _mm512_add_epi64(o, e));
}

/// The best so far, and its transform.
struct Best {
  __m512i score, transform;
};

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void keepBetter(__m512i score, std::size_t t,
                                                                   Best& best) {
  const __mmask8 better = _mm512_cmpgt_epi64_mask(score, best.score);
  best.score = _mm512_mask_mov_epi64(best.score, better, score);
  best.transform =
      _mm512_mask_mov_epi64(best.transform, better, _mm512_set1_epi64(static_cast<long long>(t)));
}

/// kTogether transforms share what is read of the places.
template <std::size_t kTogether>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline void scoreTogether(const KernelInput& input,
                                                                      std::size_t first,
                                                                      BlockScores* scores,
                                                                      Best& best) {
  const __m512i zero = _mm512_setzero_si512();
  Counts counts[kTogether];
  for (Counts& n : counts) n = {zero, zero, zero, zero};
  const QueryRow* query = input.query + first * input.rows;
  for (std::size_t row = 0; row < input.rows; ++row) {
    const __m512i learned_o = _mm512_load_si512(input.places[row].occupied.data());
    const __m512i learned_e = _mm512_load_si512(input.places[row].empty.data());
    for (std::size_t t = 0; t < kTogether; ++t) {
      count(learned_o, learned_e, query[t * input.rows + row], counts[t]);
    }
  }
  for (std::size_t t = 0; t < kTogether; ++t) {
    const __m512i score = sum(counts[t], input.factors, input.offsets[first + t]);
    _mm512_storeu_si512(scores[first + t].data(), score);
    keepBetter(score, first + t, best);
  }
}

}  // namespace

[[PLACE_MEMORY_AVX512]] BlockBest scoreBlockAvx512(const KernelInput& input, BlockScores* scores) {
  constexpr std::size_t kTogether = 2;
  Best best{_mm512_set1_epi64(std::numeric_limits<std::int64_t>::min()), _mm512_setzero_si512()};
  std::size_t t = 0;
  for (; t + kTogether <= input.transforms; t += kTogether) {
    scoreTogether<kTogether>(input, t, scores, best);
  }
  for (; t < input.transforms; ++t) scoreTogether<1>(input, t, scores, best);
  BlockBest found;
  _mm512_storeu_si512(found.score.data(), best.score);
  _mm512_storeu_si512(found.transform.data(), best.transform);
  return found;
}

}  // namespace place_memory::core

#endif
