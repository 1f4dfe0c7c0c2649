#ifndef PLACE_MEMORY_NODE_NAMES_NODE_NAMES_H
#define PLACE_MEMORY_NODE_NAMES_NODE_NAMES_H

#include <cstdint>

/// Every name the node has on the wire, for the node and for those who talk to it. Those that are
/// parameters (frames, sonar and heading topics) are in config/parameters.h.
namespace place_memory::node {

// Relative.
constexpr char kCommandTopic[] = "cmd_vel";
constexpr char kInitialPoseTopic[] = "initialpose";
constexpr char kMoveBaseName[] = "move_base";

// Private: below the node's own name.
constexpr char kScanAction[] = "scan";
constexpr char kGoToPlaceAction[] = "go_to_place";
constexpr char kExploreAction[] = "explore";

constexpr char kScanGridTopic[] = "scan_grid";
constexpr char kMatchedGridTopic[] = "matched_grid";
constexpr char kScanCellsTopic[] = "scan_cells";
constexpr char kMatchedCellsTopic[] = "matched_cells";
constexpr char kAnswerMarkersTopic[] = "answer_markers";
constexpr char kMapChangesTopic[] = "map_changes";
constexpr char kPlaceGraphTopic[] = "place_graph";
constexpr char kPlaceMarkersTopic[] = "place_markers";
constexpr char kPlaceHandlesTopic[] = "place_handles";
constexpr char kRouteTopic[] = "route";
constexpr char kMapTopic[] = "map";
constexpr char kMapMetadataTopic[] = "map_metadata";
constexpr char kRecognitionTopic[] = "recognition";
constexpr char kCurrentPlaceTopic[] = "current_place";
constexpr char kPoseTopic[] = "pose";
constexpr char kModeTopic[] = "mode";
constexpr char kBeliefTopic[] = "belief";
constexpr char kBeliefMarkersTopic[] = "belief_markers";
constexpr char kEventsTopic[] = "events";

constexpr char kLearnPlaceService[] = "learn_place";
constexpr char kRecognizePlaceService[] = "recognize_place";
constexpr char kListPlacesService[] = "list_places";
constexpr char kRenamePlaceService[] = "rename_place";
constexpr char kRemovePlaceService[] = "remove_place";
constexpr char kClearService[] = "clear";
constexpr char kGetGraphService[] = "get_graph";
constexpr char kSaveService[] = "save";
constexpr char kLoadService[] = "load";
constexpr char kMergeService[] = "merge";
constexpr char kExportService[] = "export";
constexpr char kUndoService[] = "undo";
constexpr char kStaticMapService[] = "static_map";
constexpr char kPlanRouteService[] = "plan_route";
constexpr char kReportTraversalService[] = "report_traversal";
constexpr char kSetLinkService[] = "set_link";
constexpr char kMakePlanService[] = "make_plan";
constexpr char kSetModeService[] = "set_mode";
constexpr char kRelocalizeService[] = "relocalize";
constexpr char kJudgeClosureService[] = "judge_closure";

/// What a person may choose of the menu of a place in ~place_handles: entries of its menu.
enum class PlaceEntry : std::uint32_t {
  kRecall = 1,  ///< its grid; a click does that too
  kRoute = 2,   ///< to it
  kRename = 3,  ///< in the panel
  // Of a place where scans say that the robot may be:
  kConfirm = 4,  ///< it is there
  kCut = 5,      ///< it is not
};

/// Handles of places are named so, and their id.
constexpr char kPlaceHandle[] = "place ";

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_NAMES_NODE_NAMES_H
