#ifndef PLACE_MEMORY_PICTURE_LINE_FONT_H
#define PLACE_MEMORY_PICTURE_LINE_FONT_H

#include <string>
#include <vector>

#include "picture/picture.h"

namespace place_memory::picture {

constexpr double kAdvance = 0.65;  ///< from letter to letter, of a font of size 1

/// The strokes of a text in a font of size 1, from (0, 0) on the base line. A letter that the font
/// does not have is a box.
std::vector<std::vector<Point>> strokes(const std::string& text);

/// Letters of a UTF-8 text.
std::size_t countLetters(const std::string& text);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_LINE_FONT_H
