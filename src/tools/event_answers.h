#ifndef PLACE_MEMORY_TOOLS_EVENT_ANSWERS_H
#define PLACE_MEMORY_TOOLS_EVENT_ANSWERS_H

#include <cstddef>
#include <ostream>
#include <vector>

#include "place_memory/core/place_memory.h"
#include "support/progress_bar.h"
#include "tools/bag_scanner.h"
#include "tools/bag_set.h"
#include "tools/event_table.h"
#include "tools/report_page.h"

namespace place_memory::tools {

/// Answers events one after the other, and writes what came of them: rows of the table, sections of
/// the report, and to stderr what a person should know.
class EventAnswers {
 public:
  /// `report`: null where none was asked for. All must outlive this.
  EventAnswers(const BagSet& bags, BagScanner& scanner, core::PlaceMemory& memory,
               std::ostream& table, ReportPage* report)
      : bags_(bags), scanner_(scanner), memory_(memory), table_(table), report_(report) {}

  /// Returns how many failed; stops where the table cannot be written. A visit becomes what it
  /// turns out to be.
  std::size_t answerAll(std::vector<Event>& events);

 private:
  void answer(ReportedEvent& reported);
  void write(const ReportedEvent& reported);
  void tell(const ReportedEvent& reported, support::ProgressBar& bar) const;

  const BagSet& bags_;
  BagScanner& scanner_;
  core::PlaceMemory& memory_;
  std::ostream& table_;
  ReportPage* report_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_EVENT_ANSWERS_H
