#ifndef PLACE_MEMORY_TOOLS_MAP_TABLES_H
#define PLACE_MEMORY_TOOLS_MAP_TABLES_H

#include <cstdint>
#include <vector>

#include "place_memory/core/place_memory.h"
#include "tools/record_table.h"

namespace place_memory::tools {

RecordTable placeTable(const std::vector<core::Place>& places);
/// The links of a place, and how often the robot went along them from there.
RecordTable linkTable(const core::MapSnapshot& map, const core::Place& place);
/// The newest first.
RecordTable historyTable(const std::vector<core::PastChange>& changes);
/// `bytes` of its file; 0: none.
RecordTable statsTable(const core::MapSnapshot& map, std::uintmax_t bytes);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_MAP_TABLES_H
