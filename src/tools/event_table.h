#ifndef PLACE_MEMORY_TOOLS_EVENT_TABLE_H
#define PLACE_MEMORY_TOOLS_EVENT_TABLE_H

#include <ros/time.h>

#include <istream>
#include <string>
#include <vector>

namespace place_memory::tools {

enum class Action { kLearn, kRecognize };

/// What is to be done with the scan that a bag holds between two times.
struct Event {
  ros::Time start;
  ros::Time end;
  Action action = Action::kLearn;
  std::string label;            ///< of the place to learn; empty: one is made up
  double heading_window = 0.0;  ///< [rad], in [0, pi]
};

/// Reads a table of comma-separated values (RFC 4180) with the columns start [s], end [s], action
/// (learn, recognize), label and heading_window [rad], empty where `heading_window` holds. Throws
/// std::runtime_error naming `source` and the first line that is wrong, and what is wrong with it.
std::vector<Event> readEvents(std::istream& table, const std::string& source,
                              double heading_window);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_EVENT_TABLE_H
