#include "transform_kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define PLACE_MEMORY_AVX512 gnu::target("avx512f,avx512vpopcntdq")

namespace place_memory::core {
namespace {

constexpr int kLanes = 8;  ///< rows in a vector
constexpr int kVectors = kGridSize / kLanes;
constexpr unsigned kFieldBits = 16;   ///< a count is at most 4096
constexpr __mmask8 kAllLanes = 0xff;  // GCC takes forms without a mask for uninitialized

/// The learned grid, in registers while transforms go by.
struct Learned {
  __m512i o[kVectors], e[kVectors];
};

[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i countBits(__m512i sum, __m512i bits) {
  return _mm512_add_epi64(sum, _mm512_popcnt_epi64(bits));
}

/// Rows that the mask leaves out are not read, so they may lie outside the plane.
template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i moved(const std::uint64_t* rows,
                                                                 __mmask8 mask, __m128i by) {
  const __m512i row = _mm512_maskz_loadu_epi64(mask, rows);
  return kLeft ? _mm512_maskz_sll_epi64(kAllLanes, row, by)
               : _mm512_maskz_srl_epi64(kAllLanes, row, by);
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

template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline PlaneCounts count(const Learned& learned,
                                                                     const MovedPlanes& transform) {
  const CellShift shift = transform.shift;
  const __m128i by = _mm_cvtsi32_si128(kLeft ? shift.columns : -shift.columns);
  constexpr std::uint64_t kAllRows = ~std::uint64_t{0};
  const std::uint64_t inside = shift.rows >= 0 ? kAllRows << shift.rows : kAllRows >> -shift.rows;
  const std::uint64_t* const occupied = transform.cells->occupied.data() - shift.rows;
  const std::uint64_t* const empty = transform.cells->empty.data() - shift.rows;
  const __m512i zero = _mm512_setzero_si512();
  __m512i own_o = zero, own_e = zero, oo = zero, oe = zero, eo = zero, ee = zero;
#pragma GCC unroll 8
  for (int i = 0; i < kVectors; ++i) {
    const auto mask = static_cast<__mmask8>(inside >> kLanes * i);
    const __m512i o = moved<kLeft>(occupied + kLanes * i, mask, by);
    const __m512i e = moved<kLeft>(empty + kLanes * i, mask, by);
    own_o = countBits(own_o, o);
    own_e = countBits(own_e, e);
    oo = countBits(oo, _mm512_and_si512(o, learned.o[i]));
    oe = countBits(oe, _mm512_and_si512(o, learned.e[i]));
    eo = countBits(eo, _mm512_and_si512(e, learned.o[i]));
    ee = countBits(ee, _mm512_and_si512(e, learned.e[i]));
  }
  const std::uint64_t both = overLanes(packed(packed(oo, oe, 1), packed(eo, ee, 1), 2));
  const std::uint64_t own = overLanes(packed(own_o, own_e, 1));
  constexpr std::uint64_t kField = (1U << kFieldBits) - 1U;
  return {own & kField,
          own >> kFieldBits,
          both & kField,
          both >> kFieldBits & kField,
          both >> (2 * kFieldBits) & kField,
          both >> (3 * kFieldBits)};
}

}  // namespace

[[PLACE_MEMORY_AVX512]] void countTransformsAvx512(const CellPlanes& learned,
                                                   const MovedPlanes* transforms, std::size_t size,
                                                   PlaneCounts* counts) {
  Learned rows;
#pragma GCC unroll 8
  for (int i = 0; i < kVectors; ++i) {
    rows.o[i] = _mm512_load_si512(learned.occupied.data() + kLanes * i);
    rows.e[i] = _mm512_load_si512(learned.empty.data() + kLanes * i);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const bool left = transforms[i].shift.columns >= 0;
    counts[i] = left ? count<true>(rows, transforms[i]) : count<false>(rows, transforms[i]);
  }
}

}  // namespace place_memory::core

#endif
