#ifndef PLACE_MEMORY_TOOLS_RESULT_TABLE_H
#define PLACE_MEMORY_TOOLS_RESULT_TABLE_H

#include <ostream>
#include <string>
#include <vector>

#include "place_memory/core/place_memory.h"
#include "tools/event_table.h"

namespace place_memory::tools {

/// What came of an event; fields that it has no value for stay empty.
struct Result {
  /// A match, as the report lists it.
  struct Ranked {
    std::string label;
    double probability = 0.0;
    double score = 0.0;
  };

  std::string status;   ///< ok, or a word that says what went wrong
  std::string message;  ///< what went wrong, in a sentence; where all is well, empty
  std::string verdict;  ///< of a recognition: recognized, ambiguous or unknown
  std::string place;    ///< label of the place that was learned, or that matches best
  bool matched = false;
  double score = 0.0;
  double probability = 0.0;
  core::Pose2d robot;  ///< base in the map; valid where a place was learned or matched
  double match_ms = 0.0;
  core::PlaceId place_id = core::kNoPlace;  ///< of the best match
  core::Pose2d place_from_scan;             ///< its alignment
  std::vector<Ranked> foremost;             ///< the best matches, as they are ranked
};

/// Learns or recognizes, and where places adapt, adapts the one recognized; never throws for what
/// the memory refuses.
Result run(const Event& event, const core::Scan& scan, core::PlaceMemory& memory);

void writeHeader(std::ostream& table);
void writeRow(const Event& event, const Result& result, std::ostream& table);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_RESULT_TABLE_H
