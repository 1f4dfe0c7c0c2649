#ifndef PLACE_MEMORY_RVIZ_COMMAND_H
#define PLACE_MEMORY_RVIZ_COMMAND_H

#include <string>

namespace place_memory::panel {

/// What a person can ask the node for.
enum class Command {
  kScan,
  kLearn,
  kRecognize,
  kRelocalize,
  kGoTo,
  kExplore,
  kUndo,
  kSave,
  kLoad,
  kSetMode,
  kRename,
  kRemove,
};

/// What of the node a command uses.
struct Interface {
  enum class Kind { kService, kAction };

  Kind kind;
  std::string name;  ///< below the node's name
};

Interface interfaceOf(Command command);

/// Whether a place must be chosen in the list first.
bool needsPlace(Command command);

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_COMMAND_H
