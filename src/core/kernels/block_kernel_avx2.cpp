#include "core/kernels/block_kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <algorithm>

#define PLACE_MEMORY_AVX2 [[gnu::target("avx2"), gnu::always_inline]] inline

// A shuffle of bytes looks up 32 times four bits in a table of sixteen bytes. Here the bits are
// four cells of the query under 32 transforms, and the table, that of the same cells of a place,
// holds how many pairs they make.
namespace place_memory::core {
namespace {

constexpr std::size_t kTogether = 32;  ///< transforms
constexpr std::size_t kFew = 10;       ///< fewer transforms are counted faster one at a time
constexpr std::size_t kLanes = 4;      ///< scores in a vector
constexpr std::size_t kFours = 16;     ///< groups of four cells in a row
/// The pairs in two rows fit a byte; those in four are up to 256.
constexpr std::size_t kRowsTogether = 2;
constexpr std::size_t kFoursTogether = kRowsTogether * kFours;

/// By the occupied (low half of the table's number) and the empty ones (high half) of four cells of
/// a place: how many of either are in each subset of the four, in the same halves of a byte.
struct PairTables {
  static constexpr std::size_t kSubsets = 16;

  alignas(64) std::uint8_t of[256 * kSubsets];
};

constexpr PairTables makePairTables() {
  PairTables tables{};
  for (unsigned cells = 0; cells < 256; ++cells) {
    for (unsigned bit = 0; bit < 4; ++bit) {
      const unsigned pair = (cells >> bit & 1U) + 16 * (cells >> bit >> 4U & 1U);
      for (unsigned subset = 0; subset < PairTables::kSubsets; ++subset) {
        std::uint8_t& pairs = tables.of[cells * PairTables::kSubsets + subset];
        if ((subset >> bit & 1U) != 0) pairs = static_cast<std::uint8_t>(pairs + pair);
      }
    }
  }
  return tables;
}

constexpr PairTables kPairTables = makePairTables();

/// Where the table of each four of each place begins, in bytes.
struct PlaceFours {
  alignas(32) std::uint16_t of[kBlockPlaces][kFoursTogether];
};

/// The same fours of the query, a byte for each transform.
struct QueryFours {
  __m256i occupied[kFoursTogether], empty[kFoursTogether];
};

/// What tables hold for occupied, and for empty cells of the query.
struct Pairs {
  __m256i occupied, empty;
};

/// Sums of bytes, as 16-bit numbers: `odd` of those with an odd index, `both` of these times 256
/// and of those with an even one, modulo 2^16.
struct Tally {
  __m256i both, odd;
};

enum Kind { kOccupiedOccupied, kOccupiedEmpty, kEmptyOccupied, kEmptyEmpty, kKinds };

PLACE_MEMORY_AVX2 void setTables(__m128i fours, std::uint16_t* tables) {
  _mm256_store_si256(reinterpret_cast<__m256i*>(tables),
                     _mm256_slli_epi16(_mm256_cvtepu8_epi16(fours), 4));
}

/// Of a row: first all fours in the low halves of its bytes, then those in the high halves.
PLACE_MEMORY_AVX2 void split(const BlockRow& row, std::size_t first, PlaceFours& fours) {
  const __m256i low = _mm256_set1_epi8(0x0f);
  for (std::size_t place = 0; place < kBlockPlaces; place += kLanes) {
    const __m256i o = _mm256_load_si256(reinterpret_cast<const __m256i*>(&row.occupied[place]));
    const __m256i e = _mm256_load_si256(reinterpret_cast<const __m256i*>(&row.empty[place]));
    const __m256i lows =
        _mm256_or_si256(_mm256_and_si256(o, low), _mm256_slli_epi16(_mm256_and_si256(e, low), 4));
    const __m256i highs = _mm256_or_si256(_mm256_and_si256(_mm256_srli_epi16(o, 4), low),
                                          _mm256_andnot_si256(low, e));
    const __m256i even = _mm256_unpacklo_epi64(lows, highs);
    const __m256i odd = _mm256_unpackhi_epi64(lows, highs);
    setTables(_mm256_castsi256_si128(even), fours.of[place] + first);
    setTables(_mm256_castsi256_si128(odd), fours.of[place + 1] + first);
    setTables(_mm256_extracti128_si256(even, 1), fours.of[place + 2] + first);
    setTables(_mm256_extracti128_si256(odd, 1), fours.of[place + 3] + first);
  }
}

/// One half of the steps that transpose 16 x 16 bytes, of a quarter of them: more do not fit the
/// registers.
PLACE_MEMORY_AVX2 void interleave(const __m256i* from, std::size_t i, __m256i* to) {
  const __m256i a = _mm256_unpacklo_epi8(from[i], from[i + 8]);
  const __m256i b = _mm256_unpackhi_epi8(from[i], from[i + 8]);
  const __m256i c = _mm256_unpacklo_epi8(from[i + 4], from[i + 12]);
  const __m256i d = _mm256_unpackhi_epi8(from[i + 4], from[i + 12]);
  to[4 * i] = _mm256_unpacklo_epi8(a, c);
  to[4 * i + 1] = _mm256_unpackhi_epi8(a, c);
  to[4 * i + 2] = _mm256_unpacklo_epi8(b, d);
  to[4 * i + 3] = _mm256_unpackhi_epi8(b, d);
}

/// Likewise of a row of the transforms.
PLACE_MEMORY_AVX2 void split(const QueryRow* const* transforms, std::size_t row, std::size_t first,
                             QueryFours& fours) {
  __m256i rows[16], halves[16], bytes[16];
  for (std::size_t i = 0; i < 16; ++i) {
    const std::size_t t = i < 8 ? i : i + 8;  // so that setCounts() stores them in order
    const auto* low = reinterpret_cast<const __m128i*>(transforms[t] + row);
    const auto* high = reinterpret_cast<const __m128i*>(transforms[t + 8] + row);
    rows[i] = _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(low)),
                                      _mm_loadu_si128(high), 1);
  }
  for (std::size_t i = 0; i < 4; ++i) interleave(rows, i, halves);
  for (std::size_t i = 0; i < 4; ++i) interleave(halves, i, bytes);
  const __m256i low = _mm256_set1_epi8(0x0f);
  for (std::size_t i = 0; i < 8; ++i) {
    const __m256i o = bytes[i];
    const __m256i e = bytes[i + 8];
    fours.occupied[first + i] = _mm256_and_si256(o, low);
    fours.occupied[first + 8 + i] = _mm256_and_si256(_mm256_srli_epi16(o, 4), low);
    fours.empty[first + i] = _mm256_and_si256(e, low);
    fours.empty[first + 8 + i] = _mm256_and_si256(_mm256_srli_epi16(e, 4), low);
  }
}

PLACE_MEMORY_AVX2 Pairs lookUp(const std::uint16_t* place, const QueryFours& query, std::size_t i) {
  const __m256i table = _mm256_broadcastsi128_si256(
      _mm_load_si128(reinterpret_cast<const __m128i*>(kPairTables.of + place[i])));
  return {_mm256_shuffle_epi8(table, query.occupied[i]),
          _mm256_shuffle_epi8(table, query.empty[i])};
}

/// Of three fours, the most whose pairs half a byte holds for certain.
PLACE_MEMORY_AVX2 Pairs lookUpThree(const std::uint16_t* place, const QueryFours& query,
                                    std::size_t i) {
  const Pairs a = lookUp(place, query, i);
  const Pairs b = lookUp(place, query, i + 1);
  const Pairs c = lookUp(place, query, i + 2);
  return {_mm256_add_epi8(_mm256_add_epi8(a.occupied, b.occupied), c.occupied),
          _mm256_add_epi8(_mm256_add_epi8(a.empty, b.empty), c.empty)};
}

/// Of what tables hold for one class of the query. The sum of low halves follows at the end.
struct HalfSums {
  __m256i both;  ///< of whole bytes, as 16-bit numbers
  __m256i high;  ///< of high halves, by byte
};

PLACE_MEMORY_AVX2 void add(__m256i a, __m256i b, HalfSums& sum) {
  const __m256i highs = _mm256_set1_epi8(static_cast<char>(0xf0));
  sum.both = _mm256_add_epi16(_mm256_add_epi16(sum.both, a), b);
  // The mean of two multiples of 16 is a multiple of 8, exactly: no bit of it leaves its byte.
  const __m256i mean = _mm256_avg_epu8(_mm256_and_si256(a, highs), _mm256_and_si256(b, highs));
  sum.high = _mm256_add_epi8(sum.high, _mm256_srli_epi16(mean, 3));
}

PLACE_MEMORY_AVX2 void add(__m256i counts, Tally& tally) {
  tally.both = _mm256_add_epi16(tally.both, counts);
  tally.odd = _mm256_add_epi16(tally.odd, _mm256_srli_epi16(counts, 8));
}

PLACE_MEMORY_AVX2 void add(const HalfSums& sum, Tally& occupied, Tally& empty) {
  add(_mm256_sub_epi16(sum.both, _mm256_slli_epi16(sum.high, 4)), occupied);
  add(sum.high, empty);
}

PLACE_MEMORY_AVX2 void countPairs(const std::uint16_t* place, const QueryFours& query,
                                  Tally* tally) {
  const __m256i zero = _mm256_setzero_si256();
  HalfSums o{zero, zero};
  HalfSums e{zero, zero};
  std::size_t i = 0;
  for (; i + 6 <= kFoursTogether; i += 6) {
    const Pairs a = lookUpThree(place, query, i);
    const Pairs b = lookUpThree(place, query, i + 3);
    add(a.occupied, b.occupied, o);
    add(a.empty, b.empty, e);
  }
  for (; i < kFoursTogether; i += 2) {
    const Pairs a = lookUp(place, query, i);
    const Pairs b = lookUp(place, query, i + 1);
    add(a.occupied, b.occupied, o);
    add(a.empty, b.empty, e);
  }
  add(o, tally[kOccupiedOccupied], tally[kOccupiedEmpty]);
  add(e, tally[kEmptyOccupied], tally[kEmptyEmpty]);
}

/// Pairs of a place, by kind and transform.
struct Counts {
  alignas(32) std::uint16_t of[kKinds][kTogether];
};

PLACE_MEMORY_AVX2 void setCounts(const Tally* tally, Counts& n) {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const __m256i odd = tally[kind].odd;
    const __m256i even = _mm256_sub_epi16(tally[kind].both, _mm256_slli_epi16(odd, 8));
    __m256i* counts = reinterpret_cast<__m256i*>(n.of[kind]);
    _mm256_store_si256(counts, _mm256_unpacklo_epi16(even, odd));
    _mm256_store_si256(counts + 1, _mm256_unpackhi_epi16(even, odd));
  }
}

/// Of four transforms.
PLACE_MEMORY_AVX2 __m256i points(const Counts& n, std::size_t t, const PairFactors& factors) {
  const std::int32_t of[kKinds] = {factors.occupied_occupied, factors.occupied_empty,
                                   factors.empty_occupied, factors.empty_empty};
  __m256i sum = _mm256_setzero_si256();
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const __m128i counts = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(n.of[kind] + t));
    sum = _mm256_add_epi64(
        sum, _mm256_mul_epi32(_mm256_cvtepu16_epi64(counts), _mm256_set1_epi64x(of[kind])));
  }
  return sum;
}

PLACE_MEMORY_AVX2 void transpose(__m256i* v) {
  const __m256i a = _mm256_unpacklo_epi64(v[0], v[1]);
  const __m256i b = _mm256_unpackhi_epi64(v[0], v[1]);
  const __m256i c = _mm256_unpacklo_epi64(v[2], v[3]);
  const __m256i d = _mm256_unpackhi_epi64(v[2], v[3]);
  v[0] = _mm256_permute2x128_si256(a, c, 0x20);
  v[1] = _mm256_permute2x128_si256(b, d, 0x20);
  v[2] = _mm256_permute2x128_si256(a, c, 0x31);
  v[3] = _mm256_permute2x128_si256(b, d, 0x31);
}

/// Of transforms from `first`.
PLACE_MEMORY_AVX2 void setScores(const KernelInput& input, std::size_t first, const Counts* counts,
                                 BlockScores* scores) {
  const std::size_t transforms = std::min(kTogether, input.transforms - first);
  for (std::size_t place = 0; place < kBlockPlaces; place += kLanes) {
    for (std::size_t t = 0; t < transforms; t += kLanes) {
      __m256i v[kLanes];
      for (std::size_t i = 0; i < kLanes; ++i) v[i] = points(counts[place + i], t, input.factors);
      transpose(v);
      for (std::size_t i = 0; i < std::min(kLanes, transforms - t); ++i) {
        const __m256i offset = _mm256_set1_epi64x(input.offsets[first + t + i]);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(&scores[first + t + i][place]),
                            _mm256_add_epi64(v[i], offset));
      }
    }
  }
}

/// What is past the last transform is that one again.
PLACE_MEMORY_AVX2 void scoreTogether(const KernelInput& input, const PlaceFours* places,
                                     std::size_t first, BlockScores* scores) {
  const QueryRow* transforms[kTogether];
  for (std::size_t i = 0; i < kTogether; ++i) {
    transforms[i] = input.query + std::min(first + i, input.transforms - 1) * input.rows;
  }
  const __m256i zero = _mm256_setzero_si256();
  Tally tally[kBlockPlaces][kKinds];
  for (auto& kinds : tally) {
    for (Tally& kind : kinds) kind = {zero, zero};
  }
  for (std::size_t row = 0; row < input.rows; row += kRowsTogether) {
    QueryFours query;
    for (std::size_t i = 0; i < kRowsTogether; ++i) split(transforms, row + i, i * kFours, query);
    for (std::size_t place = 0; place < kBlockPlaces; ++place) {
      countPairs(places[row / kRowsTogether].of[place], query, tally[place]);
    }
  }
  Counts counts[kBlockPlaces];
  for (std::size_t place = 0; place < kBlockPlaces; ++place) setCounts(tally[place], counts[place]);
  setScores(input, first, counts, scores);
}

}  // namespace

[[gnu::target("avx2")]] BlockBest scoreBlockAvx2(const KernelInput& input, BlockScores* scores) {
  PlaceFours places[kGridSize / kRowsTogether];
  for (std::size_t row = 0; row < input.rows; ++row) {
    split(input.places[row], row % kRowsTogether * kFours, places[row / kRowsTogether]);
  }
  std::size_t first = 0;
  for (; first + kFew <= input.transforms; first += kTogether) {
    scoreTogether(input, places, first, scores);
  }
  if (first < input.transforms) {
    // Every processor with AVX2 has this instruction too.
    scoreBlockPopcnt({input.places, input.query + first * input.rows, input.rows,
                      input.transforms - first, input.factors, input.offsets + first},
                     scores + first);
  }
  return bestOf(scores, input.transforms);
}

}  // namespace place_memory::core

#endif
