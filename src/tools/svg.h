#ifndef PLACE_MEMORY_TOOLS_SVG_H
#define PLACE_MEMORY_TOOLS_SVG_H

#include <string>
#include <string_view>

namespace place_memory::tools {

/// The text as HTML and SVG show it, in attributes too; what no text may hold is shown as \xNN.
std::string escaped(std::string_view text);

/// A number with so many decimals, whatever the locale; what is not finite as 0.
std::string decimal(double number, int decimals);

/// A title that is shown where the mouse rests.
std::string hint(std::string_view text);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_SVG_H
