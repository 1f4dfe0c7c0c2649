#include "rviz/command.h"

#include "node/names/node_names.h"

namespace place_memory::panel {

Interface interfaceOf(Command command) {
  using Kind = Interface::Kind;
  switch (command) {
    case Command::kScan:
      return {Kind::kAction, node::kScanAction};
    case Command::kLearn:
      return {Kind::kService, node::kLearnPlaceService};
    case Command::kRecognize:
      return {Kind::kService, node::kRecognizePlaceService};
    case Command::kRelocalize:
      return {Kind::kService, node::kRelocalizeService};
    case Command::kGoTo:
      return {Kind::kAction, node::kGoToPlaceAction};
    case Command::kExplore:
      return {Kind::kAction, node::kExploreAction};
    case Command::kUndo:
      return {Kind::kService, node::kUndoService};
    case Command::kSave:
      return {Kind::kService, node::kSaveService};
    case Command::kLoad:
      return {Kind::kService, node::kLoadService};
    case Command::kSetMode:
      return {Kind::kService, node::kSetModeService};
    case Command::kRename:
      return {Kind::kService, node::kRenamePlaceService};
    case Command::kRemove:
      return {Kind::kService, node::kRemovePlaceService};
  }
  return {};
}

bool needsPlace(Command command) {
  return command == Command::kGoTo || command == Command::kRename || command == Command::kRemove;
}

}  // namespace place_memory::panel
