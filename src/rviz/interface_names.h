#ifndef PLACE_MEMORY_RVIZ_INTERFACE_NAMES_H
#define PLACE_MEMORY_RVIZ_INTERFACE_NAMES_H

/// What the panel uses of a node, below the node's name. The node has the same names in
/// node/base/node_names.h, which is none of rviz's business.
namespace place_memory::panel {

constexpr char kScanAction[] = "scan";
constexpr char kGoToPlaceAction[] = "go_to_place";
constexpr char kExploreAction[] = "explore";

constexpr char kLearnPlaceService[] = "learn_place";
constexpr char kRecognizePlaceService[] = "recognize_place";
constexpr char kRelocalizeService[] = "relocalize";
constexpr char kRenamePlaceService[] = "rename_place";
constexpr char kRemovePlaceService[] = "remove_place";
constexpr char kGetGraphService[] = "get_graph";
constexpr char kUndoService[] = "undo";
constexpr char kSaveService[] = "save";
constexpr char kLoadService[] = "load";
constexpr char kSetModeService[] = "set_mode";

constexpr char kMapChangesTopic[] = "map_changes";
constexpr char kRecognitionTopic[] = "recognition";
constexpr char kBeliefTopic[] = "belief";
constexpr char kModeTopic[] = "mode";
constexpr char kEventsTopic[] = "events";

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_INTERFACE_NAMES_H
