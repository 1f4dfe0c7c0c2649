#ifndef PLACE_MEMORY_MAPPING_DRIVE_TABLE_H
#define PLACE_MEMORY_MAPPING_DRIVE_TABLE_H

#include <string>
#include <vector>

#include "mapping/mapping_figures.h"

namespace place_memory::mapping {

/// What a table of mapping drives shows.
const std::vector<std::string>& driveHeader();

/// Its row of one drive.
std::vector<std::string> driveRow(const std::string& world, const std::string& sonars,
                                  const MappingFigures& found);

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_DRIVE_TABLE_H
