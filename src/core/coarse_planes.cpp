#include "coarse_planes.h"

namespace place_memory::core {
namespace {

constexpr std::uint64_t kSecondColumns = 0x5555555555555555;
constexpr std::uint64_t kFourthColumns = 0x1111111111111111;

/// In every second column: whether two of the four cells there are set in two neighbouring rows.
std::uint64_t twoOfFour(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t a_next = a >> 1;
  const std::uint64_t b_next = b >> 1;
  return ((a & a_next) | (b & b_next) | ((a | a_next) & (b | b_next))) & kSecondColumns;
}

/// Of four rows: each bit stands for four cells.
std::uint64_t coarseWord(const std::uint64_t* rows) {
  return twoOfFour(rows[0], rows[1]) | twoOfFour(rows[2], rows[3]) << 1;
}

/// Cells set among eight: of two rows, in groups of four columns; each in four bits.
std::uint64_t countEights(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kPairs = 0x3333333333333333;
  const auto count = [](std::uint64_t row) {
    const std::uint64_t pairs = row - (row >> 1 & kSecondColumns);
    return (pairs & kPairs) + (pairs >> 2 & kPairs);
  };
  return count(a) + count(b);
}

/// Whether so many of sixteen cells are set, in every fourth column.
struct Filled {
  std::uint64_t two;
  std::uint64_t eight;
};

Filled filled(const std::uint64_t* rows) {
  const std::uint64_t upper = countEights(rows[0], rows[1]);
  const std::uint64_t lower = countEights(rows[2], rows[3]);
  // Eight and eight would not fit into four bits, so an eight is told apart and counts as seven.
  const std::uint64_t all = (upper | lower) >> 3 & kFourthColumns;
  const std::uint64_t sum =
      upper - (upper >> 3 & kFourthColumns) + lower - (lower >> 3 & kFourthColumns);
  const std::uint64_t eight = (sum >> 3 & kFourthColumns) | all;
  return {((sum >> 1 | sum >> 2) & kFourthColumns) | eight, eight};
}

}  // namespace

void coarsen(const CellPlanes& cells, QueryRow* rows) {
  for (std::size_t i = 0; i < kCoarseRows; ++i) {
    rows[i].occupied = coarseWord(cells.occupied.data() + 4 * i);
    rows[i].empty = coarseWord(cells.empty.data() + 4 * i) & ~rows[i].occupied;
  }
}

void coarsenMost(const CellPlanes& cells, QueryRow* rows) {
  for (std::size_t i = 0; i < kCoarsestRows; ++i) {
    rows[i] = {};
    for (std::size_t strip = 0; strip < 4; ++strip) {
      const std::size_t first = 16 * i + 4 * strip;
      rows[i].occupied |= filled(cells.occupied.data() + first).two << strip;
      rows[i].empty |= filled(cells.empty.data() + first).eight << strip;
    }
    rows[i].empty &= ~rows[i].occupied;
  }
}

}  // namespace place_memory::core
