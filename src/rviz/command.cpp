#include "rviz/command.h"

#include "rviz/interface_names.h"

namespace place_memory::panel {

Interface interfaceOf(Command command) {
  using Kind = Interface::Kind;
  switch (command) {
    case Command::kScan:
      return {Kind::kAction, kScanAction};
    case Command::kLearn:
      return {Kind::kService, kLearnPlaceService};
    case Command::kRecognize:
      return {Kind::kService, kRecognizePlaceService};
    case Command::kRelocalize:
      return {Kind::kService, kRelocalizeService};
    case Command::kGoTo:
      return {Kind::kAction, kGoToPlaceAction};
    case Command::kExplore:
      return {Kind::kAction, kExploreAction};
    case Command::kUndo:
      return {Kind::kService, kUndoService};
    case Command::kSave:
      return {Kind::kService, kSaveService};
    case Command::kLoad:
      return {Kind::kService, kLoadService};
    case Command::kSetMode:
      return {Kind::kService, kSetModeService};
    case Command::kRename:
      return {Kind::kService, kRenamePlaceService};
    case Command::kRemove:
      return {Kind::kService, kRemovePlaceService};
  }
  return {};
}

bool needsPlace(Command command) {
  return command == Command::kGoTo || command == Command::kRename || command == Command::kRemove;
}

}  // namespace place_memory::panel
