#ifndef PLACE_MEMORY_TOOLS_MAP_ARGUMENTS_H
#define PLACE_MEMORY_TOOLS_MAP_ARGUMENTS_H

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace place_memory::tools {

/// What the program place_memory is told.
struct MapArguments {
  std::string command;
  std::vector<std::string> words;  ///< that follow the command
  std::string store;               ///< from the root; empty: --node is given
  std::string node;
  std::vector<std::string> params;
  bool json = false;
  std::string png;    ///< picture to write; empty: none
  std::string from;   ///< another store; empty: none
  std::string label;  ///< for the new place; empty: as the scan's place
  bool scan = false;
  std::size_t count = 0;  ///< of changes; 0: as the command has it
};

/// Nothing where help was asked for, which is then written to `help`. Throws std::exception that
/// says what is wrong with the arguments.
std::optional<MapArguments> readMapArguments(int argc, const char* const* argv, std::ostream& help);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_MAP_ARGUMENTS_H
