#ifndef PLACE_MEMORY_TOOLS_NODE_DRIVE_H
#define PLACE_MEMORY_TOOLS_NODE_DRIVE_H

#include <string>

#include "tools/map_source.h"

namespace place_memory::tools {

/// Has a node drive its robot to a place, by its action ~go_to_place, and waits until that is over.
/// SIGINT cancels the goal, and the robot stands. ROS must be initialized. Throws CommandError
/// where the node does not answer.
DrivenGoal driveTo(const std::string& node, const std::string& label, const Progress& progress);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_NODE_DRIVE_H
