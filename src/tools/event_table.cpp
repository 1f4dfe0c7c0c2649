#include "tools/event_table.h"

#include <boost/lexical_cast.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "place_memory/core/pose2d.h"
#include "support/csv.h"

namespace place_memory::tools {
namespace {

const std::vector<std::string> kColumns = {"start", "end", "action", "label", "heading_window"};

// Tables give pi with a few digits.
constexpr double kWidest = core::kPi + 1e-3;

double readNumber(const std::string& column, const std::string& text, double low, double high) {
  double number = 0.0;
  if (!boost::conversion::try_lexical_convert(text, number) || !(number >= low && number <= high)) {
    throw std::runtime_error(column + " must be a number in [" + std::to_string(low) + ", " +
                             std::to_string(high) + "], not '" + text + "'");
  }
  return number;
}

ros::Time readTime(const std::string& column, const std::string& text) {
  constexpr double kLast = std::numeric_limits<std::uint32_t>::max();
  return ros::Time(readNumber(column, text, 0.0, kLast));
}

Event readEvent(const std::vector<std::string>& fields, double heading_window) {
  if (fields.size() != kColumns.size()) {
    throw std::runtime_error("has " + std::to_string(fields.size()) + " fields, not " +
                             std::to_string(kColumns.size()));
  }
  static const std::map<std::string, Action> kActions = {{"learn", Action::kLearn},
                                                         {"recognize", Action::kRecognize}};
  Event event;
  event.start = readTime("start", fields[0]);
  event.end = readTime("end", fields[1]);
  if (event.end <= event.start) throw std::runtime_error("end must be after start");
  const auto action = kActions.find(fields[2]);
  if (action == kActions.end()) {
    throw std::runtime_error("action must be learn or recognize, not '" + fields[2] + "'");
  }
  event.action = action->second;
  event.label = fields[3];
  event.heading_window = heading_window;
  if (!fields[4].empty()) {
    event.heading_window =
        std::fmin(core::kPi, readNumber("heading_window", fields[4], 0.0, kWidest));
  }
  return event;
}

}  // namespace

std::vector<Event> readEvents(std::istream& table, const std::string& source,
                              double heading_window) {
  std::vector<Event> events;
  int line = 0;
  try {
    if (support::readRecord(table, line) != kColumns) {
      throw std::runtime_error("must be the header start,end,action,label,heading_window");
    }
    while (const auto fields = support::readRecord(table, line)) {
      if (fields->size() == 1 && fields->front().empty()) continue;  // an empty line
      events.push_back(readEvent(*fields, heading_window));
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(source + ", line " + std::to_string(std::max(line, 1)) + ": " +
                             error.what());
  }
  return events;
}

}  // namespace place_memory::tools
