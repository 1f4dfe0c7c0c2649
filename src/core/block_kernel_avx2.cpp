#include "block_kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define PLACE_MEMORY_AVX2 gnu::target("avx2")

namespace place_memory::core {
namespace {

constexpr std::size_t kLanes = 4;  ///< places of a vector
constexpr std::size_t kRowsTogether = 4;

[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline __m256i load(
    const std::array<std::uint64_t, kBlockPlaces>& places, std::size_t lane) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(places.data() + lane));
}

/// Bits set in each byte.
[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline __m256i popcount(__m256i v) {
  const __m256i of_nibble = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4, 0, 1,
                                             1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
  const __m256i low = _mm256_set1_epi8(0x0f);
  const __m256i a = _mm256_shuffle_epi8(of_nibble, _mm256_and_si256(v, low));
  const __m256i b = _mm256_shuffle_epi8(of_nibble, _mm256_and_si256(_mm256_srli_epi64(v, 4), low));
  return _mm256_add_epi8(a, b);
}

/// The bits of a stream of vectors, added position by position as Harley and Seal do: only one
/// vector in four is counted on the way.
struct BitSum {
  __m256i ones, twos;
  __m256i fours;  ///< counted, by byte: at most 8 a batch, so at most 128
};

/// Adds three bits in each position: returns the carry, leaves the sum in `sum`.
[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline __m256i carry(__m256i& sum, __m256i a, __m256i b) {
  const __m256i half = _mm256_xor_si256(sum, a);
  const __m256i out = _mm256_or_si256(_mm256_and_si256(sum, a), _mm256_and_si256(half, b));
  sum = _mm256_xor_si256(half, b);
  return out;
}

[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline void add(const __m256i* v, BitSum& n) {
  const __m256i twos_a = carry(n.ones, v[0], v[1]);
  const __m256i twos_b = carry(n.ones, v[2], v[3]);
  n.fours = _mm256_add_epi8(n.fours, popcount(carry(n.twos, twos_a, twos_b)));
}

/// In each 64-bit lane.
[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline __m256i total(const BitSum& n) {
  const __m256i zero = _mm256_setzero_si256();
  const __m256i fours = _mm256_slli_epi64(_mm256_sad_epu8(n.fours, zero), 2);
  const __m256i twos = _mm256_slli_epi64(_mm256_sad_epu8(popcount(n.twos), zero), 1);
  const __m256i ones = _mm256_sad_epu8(popcount(n.ones), zero);
  return _mm256_add_epi64(_mm256_add_epi64(fours, twos), ones);
}

/// One of the two planes of a transform with four places.
struct PlanePoints {
  std::uint64_t QueryRow::*plane;
  std::int32_t on_occupied, on_empty;
};

[[PLACE_MEMORY_AVX2, gnu::always_inline]] inline __m256i scorePlane(const KernelInput& input,
                                                                    const QueryRow* query,
                                                                    std::size_t lane,
                                                                    const PlanePoints& points) {
  const __m256i zero = _mm256_setzero_si256();
  BitSum o{zero, zero, zero};
  BitSum e = o;
  for (std::size_t row = 0; row < input.rows; row += kRowsTogether) {
    __m256i both_o[kRowsTogether], both_e[kRowsTogether];
    for (std::size_t i = 0; i < kRowsTogether; ++i) {
      const BlockRow& places = input.places[row + i];
      const __m256i all = _mm256_set1_epi64x(static_cast<long long>(query[row + i].*points.plane));
      both_o[i] = _mm256_and_si256(all, load(places.occupied, lane));
      both_e[i] = _mm256_and_si256(all, load(places.empty, lane));
    }
    add(both_o, o);
    add(both_e, e);
  }
  return _mm256_add_epi64(_mm256_mul_epi32(total(o), _mm256_set1_epi64x(points.on_occupied)),
                          _mm256_mul_epi32(total(e), _mm256_set1_epi64x(points.on_empty)));
}

}  // namespace

[[PLACE_MEMORY_AVX2]] BlockBest scoreBlockAvx2(const KernelInput& input, BlockScores* scores) {
  const PairFactors& factors = input.factors;
  const PlanePoints occupied{&QueryRow::occupied, factors.occupied_occupied,
                             factors.occupied_empty};
  const PlanePoints empty{&QueryRow::empty, factors.empty_occupied, factors.empty_empty};
  for (std::size_t t = 0; t < input.transforms; ++t) {
    const QueryRow* query = input.query + t * input.rows;
    for (std::size_t lane = 0; lane < kBlockPlaces; lane += kLanes) {
      const __m256i sum =
          _mm256_add_epi64(_mm256_set1_epi64x(input.offsets[t]),
                           _mm256_add_epi64(scorePlane(input, query, lane, occupied),
                                            scorePlane(input, query, lane, empty)));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(scores[t].data() + lane), sum);
    }
  }
  return bestOf(scores, input.transforms);
}

}  // namespace place_memory::core

#endif
