#include "tools/result_table.h"

#include <algorithm>
#include <chrono>
#include <iomanip>

#include "support/csv.h"

namespace place_memory::tools {
namespace {

constexpr std::size_t kForemost = 3;

std::string toString(core::PlaceMemoryError::Reason reason) {
  using Reason = core::PlaceMemoryError::Reason;
  switch (reason) {
    case Reason::kLabelTaken:
      return "label_taken";
    case Reason::kInvalidLabel:
      return "invalid_label";
    case Reason::kUnknownPlace:
      return "unknown_place";
    case Reason::kInvalidScan:
      return "invalid_scan";
    case Reason::kWrongCells:
      return "wrong_cells";
    case Reason::kAlreadyLearned:
      return "already_learned";
    case Reason::kStoreFailed:
      return "store_failed";
    case Reason::kNoEcho:
      return "no_echo";
    case Reason::kDoubtfulScan:
      return "doubtful_scan";
    case Reason::kUnknownLink:
    case Reason::kInvalidTraversal:
    case Reason::kOtherStore:
    case Reason::kNothingToUndo:
    case Reason::kCannotUndo:
      break;  // of what no event asks for
  }
  return {};
}

Result learn(const Event& event, const core::Scan& scan, core::PlaceMemory& memory) {
  Result result;
  const core::Place place = memory.learn(scan, event.label, event.force).place;
  result.place = place.label;
  result.robot = place.map_from_place * scan.robot_in_scan;
  return result;
}

Result recognize(const Event& event, const core::Scan& scan, core::PlaceMemory& memory) {
  Result result;
  const auto before = std::chrono::steady_clock::now();
  const core::PlaceMemory::Answer answer = memory.recognize(scan, event.heading_window);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - before;
  result.match_ms = took.count();
  result.verdict = core::nameOf(answer.recognition.verdict);
  if (answer.recognition.matches.empty()) return result;
  const core::PlaceMatch& best = answer.recognition.matches.front();
  result.place = answer.labels.front();
  result.matched = true;
  result.score = best.score;
  result.probability = best.probability;
  result.robot = answer.recognition.map_from_robot;
  result.place_id = best.id;
  result.place_from_scan = best.place_from_scan;
  for (std::size_t i = 0; i < std::min(kForemost, answer.labels.size()); ++i) {
    const core::PlaceMatch& match = answer.recognition.matches[i];
    result.foremost.push_back({answer.labels[i], match.probability, match.score});
  }
  if (answer.recognition.no_echo) {
    result.message = "no echo lies in the scan's grid: it tells nothing of where it was taken";
  } else if (!answer.adapt_problem.empty()) {
    result.message = "the place is as it was: " + answer.adapt_problem;
  }
  return result;
}

}  // namespace

Result run(const Event& event, const core::Scan& scan, core::PlaceMemory& memory) {
  Result result;
  try {
    result = event.action == Action::kLearn ? learn(event, scan, memory)
                                            : recognize(event, scan, memory);
    result.status = "ok";
  } catch (const core::PlaceMemoryError& error) {
    result.status = toString(error.reason());
    result.message = error.what();
  }
  return result;
}

void writeHeader(std::ostream& table) {
  table << "start,action,status,verdict,place,score,probability,x,y,yaw,match_ms\n";
}

void writeRow(const Event& event, const Result& result, std::ostream& table) {
  const bool ok = result.status == "ok";
  table << std::fixed << std::setprecision(3) << event.start.toSec() << ','
        << (event.action == Action::kLearn ? "learn" : "recognize") << ',' << result.status << ','
        << result.verdict << ',' << support::csvField(result.place) << ',';
  if (result.matched) table << result.score;
  table << ',' << std::setprecision(4);
  if (result.matched) table << result.probability;
  table << ',';
  if (ok && !result.place.empty()) {
    table << result.robot.x << ',' << result.robot.y << ',' << core::wrapAngle(result.robot.yaw);
  } else {
    table << ",,";
  }
  table << ',';
  if (ok && event.action == Action::kRecognize) table << std::setprecision(2) << result.match_ms;
  table << '\n';
}

}  // namespace place_memory::tools
