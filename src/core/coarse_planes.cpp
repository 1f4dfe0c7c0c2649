#include "coarse_planes.h"

#include <algorithm>
#include <array>

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

/// 32 rows of coarse cells, each in every second column.
struct CoarseCells {
  explicit CoarseCells(const CellPlanes& cells) {
    for (std::size_t row = 0; row < kRows; ++row) {
      occupied[row] = twoOfFour(cells.occupied[2 * row], cells.occupied[2 * row + 1]);
      empty[row] = twoOfFour(cells.empty[2 * row], cells.empty[2 * row + 1]) & ~occupied[row];
    }
  }

  static constexpr std::size_t kRows = kGridSize / 2;
  std::array<std::uint64_t, kRows> occupied, empty;
};

std::uint64_t shiftedColumns(std::uint64_t row, int by) { return by >= 0 ? row << by : row >> -by; }

/// Two rows of coarse cells share a word.
void pack(const CoarseCells& cells, CellShift shift, QueryRow* rows) {
  for (std::size_t i = 0; i < kCoarseRows; ++i) rows[i] = {};
  const int first = std::max(0, shift.rows / 2);
  const int end = static_cast<int>(CoarseCells::kRows) + std::min(0, shift.rows / 2);
  for (int row = first; row < end; ++row) {
    const auto from = static_cast<std::size_t>(row - shift.rows / 2);
    QueryRow& to = rows[row / 2];
    to.occupied |= shiftedColumns(cells.occupied[from], shift.columns) << row % 2;
    to.empty |= shiftedColumns(cells.empty[from], shift.columns) << row % 2;
  }
}

BitPlane shifted(const BitPlane& plane, CellShift shift) {
  BitPlane moved{};
  const int first = std::max(0, shift.rows);
  const int end = std::min(kGridSize, kGridSize + shift.rows);
  const std::uint64_t* from = plane.data() + (first - shift.rows);
  std::uint64_t* to = moved.data() + first;
  for (int row = 0; row < end - first; ++row) to[row] = shiftedColumns(from[row], shift.columns);
  return moved;
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

void coarsen(const CellPlanes& cells, QueryRow* rows) { pack(CoarseCells(cells), {0, 0}, rows); }

void coarsenShifted(const CellPlanes& cells, const std::vector<CellShift>& shifts, QueryRow* rows) {
  const CoarseCells coarse(cells);
  for (std::size_t i = 0; i < shifts.size(); ++i) pack(coarse, shifts[i], rows + i * kCoarseRows);
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

void coarsenMostShifted(const CellPlanes& cells, const std::vector<CellShift>& shifts,
                        QueryRow* rows) {
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    CellPlanes moved;
    moved.occupied = shifted(cells.occupied, shifts[i]);
    moved.empty = shifted(cells.empty, shifts[i]);
    coarsenMost(moved, rows + i * kCoarsestRows);
  }
}

}  // namespace place_memory::core
