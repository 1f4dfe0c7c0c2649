#ifndef PLACE_MEMORY_PICTURE_PNG_H
#define PLACE_MEMORY_PICTURE_PNG_H

#include <string>
#include <vector>

#include "picture/picture.h"

namespace place_memory::picture {

/// The bytes of a PNG file (W3C Portable Network Graphics, 8 bits a channel). Row by row from the
/// top, `width` pixels each.
std::string encodePng(const std::vector<Color>& pixels, int width);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_PNG_H
