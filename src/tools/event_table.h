#ifndef PLACE_MEMORY_TOOLS_EVENT_TABLE_H
#define PLACE_MEMORY_TOOLS_EVENT_TABLE_H

#include <ros/time.h>

#include <istream>
#include <string>
#include <vector>

namespace place_memory::tools {

enum class Action { kLearn, kRecognize };

/// What is to be done with the scan that a bag holds between two times, those of header stamps.
struct Event {
  ros::Time start;
  ros::Time end;
  Action action = Action::kLearn;
  std::string label;            ///< of the place to learn; empty: one is made up
  double heading_window = 0.0;  ///< [rad], in [0, pi]
  bool force = false;           ///< learn although the scan holds no echo
  bool visit = false;           ///< recognize, and learn where the answer is UNKNOWN
};

/// No event is longer: of the readings and transforms between its times all are kept [s].
constexpr double kLongestEvent = 86400.0;

/// Reads a table of comma-separated values (RFC 4180, in UTF-8) with the columns start [s], end
/// [s], action (learn, recognize), label, heading_window [rad], empty where `heading_window` holds,
/// and, which may be left out, force (true, false). A time as +12.5 lies so long after `bag_start`.
/// What is empty at the end of a row may be left out; empty rows and lines that begin with # are.
/// Throws std::runtime_error naming `source` and the first line that is wrong, and what is wrong
/// with it.
std::vector<Event> readEvents(std::istream& table, const std::string& source, double heading_window,
                              const ros::Time& bag_start);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_EVENT_TABLE_H
