#ifndef PLACE_MEMORY_PICTURE_SVG_TEXT_H
#define PLACE_MEMORY_PICTURE_SVG_TEXT_H

#include <string>
#include <string_view>

#include "picture/picture.h"

namespace place_memory::picture {

/// The text as HTML and SVG show it, in attributes too; what no text may hold is shown as \xNN.
std::string escaped(std::string_view text);

/// A number with so many decimals, whatever the locale; what is not finite as 0.
std::string decimal(double number, int decimals);

/// As "#rrggbb".
std::string hex(const Color& color);

/// A title that is shown where the mouse rests.
std::string hint(std::string_view text);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_SVG_TEXT_H
