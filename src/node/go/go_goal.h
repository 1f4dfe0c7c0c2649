#ifndef PLACE_MEMORY_NODE_GO_GO_GOAL_H
#define PLACE_MEMORY_NODE_GO_GO_GOAL_H

#include <place_memory/ExploreGoal.h>
#include <place_memory/ExploreResult.h>
#include <place_memory/GoToPlaceGoal.h>
#include <place_memory/GoToPlaceResult.h>

#include <optional>
#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Where a goal of ~go_to_place leads: a place of the map, by its id, or a pose. Nothing where it
/// cannot be taken, which `result` then says.
std::optional<core::RouteEnd> readGoal(const GoToPlaceGoal& goal, const core::PlaceMemory& memory,
                                       const std::string& map_frame, GoToPlaceResult& result);

/// Whether a goal of ~explore can be taken; where not, `result` says why.
bool isTaken(const ExploreGoal& goal, ExploreResult& result);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_GO_GOAL_H
