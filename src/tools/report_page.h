#ifndef PLACE_MEMORY_TOOLS_REPORT_PAGE_H
#define PLACE_MEMORY_TOOLS_REPORT_PAGE_H

#include <cstddef>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/fused_map.h"
#include "place_memory/core/place_memory.h"
#include "tools/event_table.h"
#include "tools/result_table.h"

namespace place_memory::tools {

/// What the report shows of an event.
struct ReportedEvent {
  std::size_t number = 0;
  Event event;
  Result result;
  std::shared_ptr<const core::Scan> scan;   ///< null: there is none
  std::optional<core::EvidenceGrid> place;  ///< grid of the best match
  std::string left_out;                     ///< which readings, in words
  std::string problem;                      ///< of an input, in a sentence
};

/// A page that says and shows what came of each event. It needs nothing but itself. Sections are
/// written as they come, so that it may be of any length.
class ReportPage {
 public:
  /// `notes`: sentences on the bags. Throws std::runtime_error where the file cannot be written.
  ReportPage(const std::string& path, const std::string& bags,
             const std::vector<std::string>& notes);

  void add(const ReportedEvent& event);
  /// Writes totals and map, for which the grids of places of cells of `cell_size` [m] are asked
  /// for. Throws std::runtime_error where the file could not be written.
  void finish(const core::MapSnapshot& map, const core::FusedMap::GridOf& grid_of,
              double cell_size);

 private:
  std::string path_;
  std::ofstream page_;
  std::map<std::string, std::size_t> totals_;  // events by what came of them
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_REPORT_PAGE_H
