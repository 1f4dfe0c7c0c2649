#ifndef PLACE_MEMORY_TOOLS_COMMAND_LINE_H
#define PLACE_MEMORY_TOOLS_COMMAND_LINE_H

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tools/drive_run.h"

namespace place_memory::tools {

/// What place_memory_bag is told.
struct Arguments {
  std::vector<std::string> bags;
  std::string events;  ///< empty: the stretches where the robot stands or turns are taken
  std::string out;
  std::string report;  ///< page to write; empty: none
  std::vector<std::string> params;
  std::string store;     ///< from the root; empty: that of the parameters
  DriveArguments drive;  ///< where its mode is empty, events are answered
};

/// Nothing where help was asked for, which is then written to `help`. Throws std::exception that
/// says what is wrong with the arguments.
std::optional<Arguments> readArguments(int argc, const char* const* argv, std::ostream& help);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_COMMAND_LINE_H
