#ifndef PLACE_MEMORY_TOOLS_PNG_H
#define PLACE_MEMORY_TOOLS_PNG_H

#include <cstdint>
#include <string>
#include <vector>

#include "place_memory/core/evidence_grid.h"

namespace place_memory::tools {

/// A picture in shades of grey, row by row from the top; 0 is black.
struct GreyPicture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The picture as a PNG file, not compressed: a library for that would be one more to depend on.
std::string asPng(const GreyPicture& picture);

/// A place's grid with `scale` x `scale` pixels a cell, y up: dark is occupied, light is empty.
GreyPicture pictureOf(const core::EvidenceGrid& grid, std::uint32_t scale);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_PNG_H
