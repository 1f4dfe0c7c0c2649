#include "core/grid/cell_planes.h"

namespace place_memory::core {
namespace {

constexpr std::uint64_t kHighest = 0x8080808080808080;  ///< bit of each byte
constexpr std::size_t kBytes = 8;

std::uint64_t bytesOf(const std::int8_t* cells) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < kBytes; ++i) {
    bytes |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(cells[i])) << 8 * i;
  }
  return bytes;
}

/// Of eight bytes, the highest bit of each: that of the first byte becomes the lowest bit.
std::uint64_t gatherHighest(std::uint64_t bytes) {
  return (bytes >> 7 & 0x0101010101010101) * 0x0102040810204080 >> 56;
}

}  // namespace

CellPlanes::CellPlanes(const EvidenceGrid& grid) {
  for (std::size_t row = 0; row < kGridSize; ++row) {
    const std::int8_t* cells = grid.cells().data() + row * kGridSize;
    for (std::size_t column = 0; column < kGridSize; column += kBytes) {
      const std::uint64_t bytes = bytesOf(cells + column);
      const std::uint64_t below = bytes & kHighest;
      const std::uint64_t sensed = (((bytes & ~kHighest) + ~kHighest) | bytes) & kHighest;
      occupied[row] |= gatherHighest(sensed & ~below) << column;
      empty[row] |= gatherHighest(below) << column;
    }
  }
}

}  // namespace place_memory::core
