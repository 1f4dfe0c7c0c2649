#ifndef PLACE_MEMORY_CORE_STORE_PACKED_EDITS_H
#define PLACE_MEMORY_CORE_STORE_PACKED_EDITS_H

#include <optional>
#include <vector>

#include "core/store/packed_bytes.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {

/// Edits of a map with the grids and readings that belong to them.
void packEdits(const std::vector<MapEdit>& edits, BytePacker& bytes);

/// Nothing where the bytes are no such edits. `cell_size` is that of the grids [m].
std::optional<std::vector<MapEdit>> unpackEdits(ByteUnpacker& bytes, double cell_size);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PACKED_EDITS_H
