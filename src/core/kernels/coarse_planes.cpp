#include "core/kernels/coarse_planes.h"

#include <algorithm>
#include <array>

#include "core/kernels/cpu.h"

namespace place_memory::core {
namespace {

constexpr std::uint64_t kFourthColumns = 0x1111111111111111;
constexpr std::size_t kSide = 4;  ///< cells along the side of a coarse one

/// Unsensed rows are put before and behind a plane, so that coarse rows may begin there.
constexpr std::size_t kPad = kGridSize;
constexpr std::size_t kPadded = kPad + kGridSize + kPad;
constexpr std::size_t kStripsAWord = 4;

/// What coarse cells are made of whose uppermost row is any row of a plane.
struct Strips {
  std::array<std::uint64_t, kPadded> fours{};    ///< cells set in groups of four columns, by row
  std::array<std::uint64_t, kPadded> filled{};   ///< in every fourth column; from each row on
  std::array<std::uint64_t, kPadded> words{};    ///< of the strips that begin at each fourth row
  std::array<std::uint16_t, kGridSize + 1> set;  ///< cells set before each row
};

/// Whether so many cells of each sixteen are set: of four rows, in every fourth column.
template <bool kTwo>
[[gnu::always_inline]] inline std::uint64_t filled(const std::uint64_t* fours) {
  const std::uint64_t upper = fours[0] + fours[1];
  const std::uint64_t lower = fours[2] + fours[3];
  // Eight and eight would not fit into four bits, so an eight is told apart and counts as seven.
  const std::uint64_t all = (upper | lower) >> 3 & kFourthColumns;
  const std::uint64_t sum =
      upper - (upper >> 3 & kFourthColumns) + lower - (lower >> 3 & kFourthColumns);
  const std::uint64_t eight = (sum >> 3 & kFourthColumns) | all;
  return kTwo ? ((sum >> 1 | sum >> 2) & kFourthColumns) | eight : eight;
}

[[gnu::always_inline]] inline void countFours(const BitPlane& plane, int columns, Strips& strips) {
  constexpr std::uint64_t kSecondColumns = 0x5555555555555555, kPairs = 0x3333333333333333;
  const int left = std::max(0, columns), right = std::max(0, -columns);
  for (std::size_t row = 0; row < kGridSize; ++row) {
    const std::uint64_t cells = plane[row] << left >> right;
    const std::uint64_t pairs = cells - (cells >> 1 & kSecondColumns);
    strips.fours[kPad + row] = (pairs & kPairs) + (pairs >> 2 & kPairs);
  }
}

[[gnu::always_inline]] inline void countRows(Strips& strips) {
  constexpr std::uint64_t kEighthColumns = 0x0f0f0f0f0f0f0f0f;
  std::array<std::uint64_t, kGridSize> of_row;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    std::uint64_t set = strips.fours[kPad + row];
    set = (set + (set >> 4)) & kEighthColumns;
    set += set >> 32;
    set += set >> 16;
    set += set >> 8;
    of_row[row] = set & 0xff;
  }
  std::uint64_t set = 0;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    strips.set[row] = static_cast<std::uint16_t>(set);
    set += of_row[row];
  }
  strips.set[kGridSize] = static_cast<std::uint16_t>(set);
}

template <bool kTwo>
[[gnu::always_inline]] inline void fillStrips(const BitPlane& plane, int columns, Strips& strips) {
  countFours(plane, columns, strips);
  for (std::size_t row = kPad - (kSide - 1); row < kPad + kGridSize; ++row) {
    strips.filled[row] = filled<kTwo>(strips.fours.data() + row);
  }
  constexpr std::size_t kRowsAWord = kSide * kStripsAWord;
  for (std::size_t row = kPad - (kRowsAWord - 1); row < kPad + kGridSize; ++row) {
    const std::uint64_t* strip = strips.filled.data() + row;
    strips.words[row] =
        (strip[0] | strip[kSide] << 1) | (strip[2 * kSide] << 2 | strip[3 * kSide] << 3);
  }
  countRows(strips);
}

[[gnu::always_inline]] inline void pack(const Strips& occupied, const Strips& empty, int shift,
                                        QueryRow* rows) {
  const auto first = static_cast<std::size_t>(static_cast<int>(kPad) - shift);
  for (std::size_t i = 0; i < kCoarsestRows; ++i) {
    const std::size_t row = first + kSide * kStripsAWord * i;
    rows[i] = {occupied.words[row], empty.words[row] & ~occupied.words[row]};
  }
}

[[gnu::always_inline]] inline std::uint16_t setAfter(const Strips& strips, int shift) {
  const auto first = static_cast<std::size_t>(std::max(0, -shift));
  const auto end = static_cast<std::size_t>(kGridSize - std::max(0, shift));
  return static_cast<std::uint16_t>(strips.set[end] - strips.set[first]);
}

[[gnu::always_inline]] inline void coarsenAll(const CellPlanes& cells, const int* by,
                                              std::size_t count, QueryRow* rows,
                                              CellTotals* inside) {
  Strips occupied, empty;
  for (std::size_t column = 0; column < count; ++column) {
    fillStrips<true>(cells.occupied, by[column], occupied);
    fillStrips<false>(cells.empty, by[column], empty);
    for (std::size_t row = 0; row < count; ++row) {
      const std::size_t i = row * count + column;
      pack(occupied, empty, by[row], rows + i * kCoarsestRows);
      inside[i] = {setAfter(occupied, by[row]), setAfter(empty, by[row])};
    }
  }
}

using Coarsen = void (*)(const CellPlanes&, const int*, std::size_t, QueryRow*, CellTotals*);

void coarsenPortable(const CellPlanes& cells, const int* by, std::size_t count, QueryRow* rows,
                     CellTotals* inside) {
  coarsenAll(cells, by, count, rows, inside);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void coarsenAvx2(const CellPlanes& cells, const int* by, std::size_t count,
                                         QueryRow* rows, CellTotals* inside) {
  coarsenAll(cells, by, count, rows, inside);
}

// GCC takes vectors of 256 bits otherwise; clang knows no such word.
#if defined(__clang__)
#define PLACE_MEMORY_AVX512 "avx512f,avx512bw,avx512vl"
#else
#define PLACE_MEMORY_AVX512 "avx512f,avx512bw,avx512vl,prefer-vector-width=512"
#endif
[[gnu::target(PLACE_MEMORY_AVX512)]] void coarsenAvx512(const CellPlanes& cells, const int* by,
                                                        std::size_t count, QueryRow* rows,
                                                        CellTotals* inside) {
  coarsenAll(cells, by, count, rows, inside);
}
#endif

std::vector<KernelVariant<Coarsen>> coarsenKernels() {
  return {
    {InstructionSet::kPortable, coarsenPortable},
#if defined(__x86_64__)
        {InstructionSet::kAvx2, coarsenAvx2}, {InstructionSet::kAvx512, coarsenAvx512},
#endif
  };
}

}  // namespace

void coarsenMost(const CellPlanes& cells, QueryRow* rows) {
  constexpr int kUnmoved = 0;
  CellTotals all;
  coarsenPortable(cells, &kUnmoved, 1, rows, &all);
}

void coarsenShifted(const CellPlanes& cells, const std::vector<int>& by, QueryRow* rows,
                    CellTotals* inside) {
  static const Coarsen coarsen = chosenKernel(coarsenKernels());
  coarsen(cells, by.data(), by.size(), rows, inside);
}

}  // namespace place_memory::core
