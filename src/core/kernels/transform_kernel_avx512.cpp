#include "core/kernels/transform_kernel.h"

#if defined(__x86_64__)

#include "core/kernels/avx512_counts.h"

namespace place_memory::core {
namespace {

using avx512::kAllLanes;
using avx512::kLanes;

constexpr int kVectors = kGridSize / kLanes;

/// The learned grid, in registers while transforms go by.
struct Learned {
  __m512i o[kVectors], e[kVectors];
};

/// Rows that the mask leaves out are not read, so they may lie outside the plane.
template <bool kLeft>
[[PLACE_MEMORY_AVX512, gnu::always_inline]] inline __m512i moved(const std::uint64_t* rows,
                                                                 __mmask8 mask, __m128i by) {
  const __m512i row = _mm512_maskz_loadu_epi64(mask, rows);
  return kLeft ? _mm512_maskz_sll_epi64(kAllLanes, row, by)
               : _mm512_maskz_srl_epi64(kAllLanes, row, by);
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
  avx512::Sums sums{zero, zero, zero, zero, zero, zero};
#pragma GCC unroll 8
  for (int i = 0; i < kVectors; ++i) {
    const auto mask = static_cast<__mmask8>(inside >> kLanes * i);
    const __m512i o = moved<kLeft>(occupied + kLanes * i, mask, by);
    const __m512i e = moved<kLeft>(empty + kLanes * i, mask, by);
    avx512::addRows(o, e, learned.o[i], learned.e[i], sums);
  }
  return avx512::total(sums);
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
