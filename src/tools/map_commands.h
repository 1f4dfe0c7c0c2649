#ifndef PLACE_MEMORY_TOOLS_MAP_COMMANDS_H
#define PLACE_MEMORY_TOOLS_MAP_COMMANDS_H

#include <ostream>

#include "tools/map_arguments.h"
#include "tools/map_source.h"

namespace place_memory::tools {

/// Does what the arguments say and writes what comes of it: what is asked for to `out`, what else a
/// person should know to `notes`. Throws CommandError, and other std::exception that says why.
ExitStatus runCommand(const MapArguments& arguments, std::ostream& out, std::ostream& notes);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_MAP_COMMANDS_H
