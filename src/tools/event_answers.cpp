#include "tools/event_answers.h"

#include <exception>
#include <iostream>
#include <string>

#include "tools/result_table.h"

namespace place_memory::tools {
namespace {

Result runVisit(Event& event, const core::Scan& scan, core::PlaceMemory& memory) {
  const Result result = run(event, scan, memory);
  const bool is_unknown = result.verdict == core::nameOf(core::Verdict::kUnknown);
  if (!event.visit || !is_unknown) return result;
  event.action = Action::kLearn;
  return run(event, scan, memory);
}

}  // namespace

void EventAnswers::answer(ReportedEvent& reported) {
  Event& event = reported.event;
  Result& result = reported.result;
  BagScan scan;
  try {
    scan = scanner_.scan(event.start, event.end);
  } catch (const std::exception& error) {  // of rosbag, and of what messages are made from
    result.status = "damaged_bag";
    result.message = std::string("the bag is damaged there: ") + error.what();
    return;
  }
  reported.scan = scan.outcome.scan;
  reported.left_out = scan.left_out;
  reported.problem = scan.outcome.problem;
  if (scan.outcome.scan) {
    result = runVisit(event, *scan.outcome.scan, memory_);
    return;
  }
  result.status = node::toString(scan.outcome.status);
  // Where the bag holds nothing, there is nothing to ask about sensors.
  const std::string missing = bags_.missing(event.start, event.end);
  result.message = missing.empty() ? scan.outcome.message : missing;
}

void EventAnswers::write(const ReportedEvent& reported) {
  writeRow(reported.event, reported.result, table_);
  table_.flush();
  if (report_ == nullptr) return;
  ReportedEvent pictured = reported;
  try {
    if (reported.result.matched) pictured.place = memory_.grid(reported.result.place_id);
  } catch (const core::PlaceMemoryError& error) {
    pictured.problem += std::string(pictured.problem.empty() ? "" : "; ") +
                        "no picture of the place: " + error.what();
  }
  report_->add(pictured);
}

void EventAnswers::tell(const ReportedEvent& reported, support::ProgressBar& bar) const {
  const std::string event = "event " + std::to_string(reported.number);
  const Result& result = reported.result;
  if (!reported.problem.empty()) bar.note(event + ": " + reported.problem);
  std::string text = event;
  if (result.status != "ok") text += ": " + result.status;
  if (!result.message.empty()) text += ": " + result.message;
  if (text != event) bar.note(text);
}

std::size_t EventAnswers::answerAll(std::vector<Event>& events) {
  std::size_t failed = 0;
  support::ProgressBar bar(events.size(), "events", std::cerr);
  for (std::size_t i = 0; i < events.size() && table_; ++i) {
    bar.show(i);
    ReportedEvent reported;
    reported.number = i + 1;
    reported.event = events[i];
    answer(reported);
    if (reported.result.status != "ok") ++failed;
    tell(reported, bar);
    write(reported);
  }
  bar.show(events.size());
  bar.finish();
  return failed;
}

}  // namespace place_memory::tools
