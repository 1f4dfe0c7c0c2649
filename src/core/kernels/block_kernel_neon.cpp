#include "core/kernels/block_kernel.h"

#if defined(__aarch64__)

#include <arm_neon.h>

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr std::size_t kLanes = 2;        ///< places of a vector
constexpr std::size_t kRowsABatch = 16;  ///< a byte counts up to 8 cells a row

/// Pairs of one kind in a batch of rows, a byte of each place's rows at a time.
inline void count(uint64x2_t query, uint64x2_t learned, uint8x16_t& n) {
  n = vaddq_u8(n, vcntq_u8(vreinterpretq_u8_u64(vandq_u64(query, learned))));
}

inline uint64x2_t widened(uint8x16_t n) { return vpaddlq_u32(vpaddlq_u16(vpaddlq_u8(n))); }

inline int64x2_t points(uint64x2_t counts, std::int32_t factor) {
  return vmull_n_s32(vmovn_s64(vreinterpretq_s64_u64(counts)), factor);
}

int64x2_t scorePlaces(const KernelInput& input, const QueryRow* query, std::size_t lane) {
  uint64x2_t oo = vdupq_n_u64(0), oe = oo, eo = oo, ee = oo;
  for (std::size_t row = 0; row < input.rows;) {
    uint8x16_t batch_oo = vdupq_n_u8(0), batch_oe = batch_oo;
    uint8x16_t batch_eo = batch_oo, batch_ee = batch_oo;
    const std::size_t end = std::min(row + kRowsABatch, input.rows);
    for (; row < end; ++row) {
      const uint64x2_t o = vdupq_n_u64(query[row].occupied);
      const uint64x2_t e = vdupq_n_u64(query[row].empty);
      const uint64x2_t learned_o = vld1q_u64(input.places[row].occupied.data() + lane);
      const uint64x2_t learned_e = vld1q_u64(input.places[row].empty.data() + lane);
      count(o, learned_o, batch_oo);
      count(o, learned_e, batch_oe);
      count(e, learned_o, batch_eo);
      count(e, learned_e, batch_ee);
    }
    oo = vaddq_u64(oo, widened(batch_oo));
    oe = vaddq_u64(oe, widened(batch_oe));
    eo = vaddq_u64(eo, widened(batch_eo));
    ee = vaddq_u64(ee, widened(batch_ee));
  }
  const PairFactors& factors = input.factors;
  return vaddq_s64(
      vaddq_s64(points(oo, factors.occupied_occupied), points(oe, factors.occupied_empty)),
      vaddq_s64(points(eo, factors.empty_occupied), points(ee, factors.empty_empty)));
}

}  // namespace

BlockBest scoreBlockNeon(const KernelInput& input, BlockScores* scores) {
  for (std::size_t t = 0; t < input.transforms; ++t) {
    for (std::size_t lane = 0; lane < kBlockPlaces; lane += kLanes) {
      vst1q_s64(scores[t].data() + lane,
                vaddq_s64(vdupq_n_s64(input.offsets[t]),
                          scorePlaces(input, input.query + t * input.rows, lane)));
    }
  }
  return bestOf(scores, input.transforms);
}

}  // namespace place_memory::core

#endif
