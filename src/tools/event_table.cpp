#include "tools/event_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "place_memory/core/pose2d.h"
#include "support/csv.h"
#include "support/text.h"

namespace place_memory::tools {
namespace {

const std::vector<std::string> kColumns = {"start",          "end",  "action", "label",
                                           "heading_window", "force"};
constexpr std::size_t kWithoutForce = 5;
constexpr std::size_t kNeeded = 3;

// Tables give pi with a few digits.
constexpr double kWidest = core::kPi + 1e-3;

// ROS counts seconds in 32 bits, and whoever reads a scan looks some time beyond its end.
constexpr double kLast = 4294960000.0;

[[noreturn]] void refuse(const std::string& column, const std::string& rule,
                         const std::string& text) {
  throw std::runtime_error(column + " must be " + rule + ", not '" + support::printable(text) +
                           "'");
}

ros::Time readTime(const std::string& column, const std::string& text, const ros::Time& bag_start) {
  const bool is_relative = !text.empty() && text.front() == '+';
  const auto number = support::parseDecimal(is_relative ? text.substr(1) : text);
  const double latest = is_relative ? kLast - bag_start.toSec() : kLast;
  if (!number || !(*number >= 0.0 && *number <= latest)) {
    refuse(column,
           "a number of seconds from 0 to 4294960000, or +seconds since the first header stamp",
           text);
  }
  // Large ones do not fit into ros::Duration.
  const ros::Time time(*number);
  if (!is_relative) return time;
  return ros::Time().fromNSec(bag_start.toNSec() + time.toNSec());
}

double readWindow(const std::string& text, double heading_window) {
  if (text.empty()) return heading_window;
  const auto number = support::parseDecimal(text);
  if (!number || !(*number >= 0.0 && *number <= kWidest)) {
    refuse("heading_window", "a number from 0 to pi [rad]", text);
  }
  return std::fmin(core::kPi, *number);
}

template <class Value>
Value readWord(const std::string& column, const std::map<std::string, Value>& words,
               const std::string& rule, const std::string& text) {
  const auto word = words.find(text);
  if (word == words.end()) refuse(column, rule, text);
  return word->second;
}

Event readEvent(const std::vector<std::string>& fields, double heading_window,
                const ros::Time& bag_start) {
  Event event;
  event.start = readTime("start", fields[0], bag_start);
  event.end = readTime("end", fields[1], bag_start);
  if (event.end <= event.start) throw std::runtime_error("end must be after start");
  if (event.end.toSec() - event.start.toSec() > kLongestEvent) {
    throw std::runtime_error("end must be at most a day after start");
  }
  event.action =
      readWord<Action>("action", {{"learn", Action::kLearn}, {"recognize", Action::kRecognize}},
                       "learn or recognize", fields[2]);
  event.label = fields[3];
  event.heading_window = readWindow(fields[4], heading_window);
  event.force = readWord<bool>("force",
                               {{"", false},
                                {"false", false},
                                {"no", false},
                                {"0", false},
                                {"true", true},
                                {"yes", true},
                                {"1", true}},
                               "true or false", fields[5]);
  return event;
}

/// The number of columns.
std::size_t readHeader(const std::optional<std::vector<std::string>>& fields) {
  if (fields && std::equal(fields->begin(), fields->end(), kColumns.begin(), kColumns.end())) {
    return kColumns.size();
  }
  if (fields && fields->size() == kWithoutForce &&
      std::equal(fields->begin(), fields->end(), kColumns.begin())) {
    return kWithoutForce;
  }
  std::string rule = "must be the header start,end,action,label,heading_window, with ,force or not";
  const std::string first = fields ? fields->front() : "";
  if (first.find_first_of(";\t") != std::string::npos) {
    const bool by_tabs = first.find('\t') != std::string::npos;
    rule += std::string("; this table is divided by ") + (by_tabs ? "tabs" : "semicolons") +
            ": save it with commas, and with points in its decimals";
  }
  throw std::runtime_error(rule);
}

/// The fields of a row, an empty one for each that is left out at its end. Nothing where the row
/// is empty.
std::optional<std::vector<std::string>> completed(std::vector<std::string> fields,
                                                  std::size_t columns) {
  const std::size_t given = fields.size();
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  if (fields.empty()) return std::nullopt;
  if (given < kNeeded) {
    throw std::runtime_error("has " + std::to_string(given) + " fields, and no " + kColumns[given]);
  }
  if (fields.size() > columns) {
    throw std::runtime_error("has " + std::to_string(given) + " fields, not " +
                             std::to_string(columns));
  }
  fields.resize(kColumns.size());
  return fields;
}

}  // namespace

std::vector<Event> readEvents(std::istream& table, const std::string& source, double heading_window,
                              const ros::Time& bag_start) {
  std::string text;
  try {
    text = support::decodedText({std::istreambuf_iterator<char>(table), {}});
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(source + ", " + error.what());
  }
  std::istringstream input(text);
  std::vector<Event> events;
  int line = 0;
  try {
    const std::size_t columns = readHeader(support::readRecord(input, line));
    while (const auto fields = support::readRecord(input, line)) {
      const auto row = completed(*fields, columns);
      if (row) events.push_back(readEvent(*row, heading_window, bag_start));
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(source + ", line " + std::to_string(std::max(line, 1)) + ": " +
                             error.what());
  }
  return events;
}

}  // namespace place_memory::tools
