#ifndef PLACE_MEMORY_TOOLS_MAP_PICTURE_H
#define PLACE_MEMORY_TOOLS_MAP_PICTURE_H

#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::tools {

/// The map as SVG: its places and links, x to the right, a picture a session, as each session has
/// a frame of its own.
std::string mapPictures(const core::MapSnapshot& map);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_MAP_PICTURE_H
