#ifndef PLACE_MEMORY_MAPPING_DRIVE_TABLE_H
#define PLACE_MEMORY_MAPPING_DRIVE_TABLE_H

#include <cstddef>
#include <string>
#include <vector>

#include "mapping/mapping_figures.h"

namespace place_memory::mapping {

/// What a table of mapping drives shows.
const std::vector<std::string>& driveHeader();

/// Its row of one drive.
std::vector<std::string> driveRow(const std::string& world, const std::string& sonars,
                                  const MappingFigures& found);

/// The same of several drives in a row.
const std::vector<std::string>& sumsHeader();

/// Sums of doubled places, false ties and answers, means of the rest, and the largest final.
std::vector<std::string> sumsRow(const std::string& drives,
                                 const std::vector<MappingFigures>& runs);

/// Of one figure that is counted.
std::size_t sumOf(const std::vector<MappingFigures>& runs, std::size_t MappingFigures::*of);

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_DRIVE_TABLE_H
