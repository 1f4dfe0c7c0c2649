#include "node/go/go_goal.h"

#include <algorithm>
#include <cmath>

#include "node/input/transform_filter.h"
#include "support/text.h"

namespace place_memory::node {

std::optional<core::RouteEnd> readGoal(const GoToPlaceGoal& goal, const core::PlaceMemory& memory,
                                       const std::string& map_frame, GoToPlaceResult& result) {
  if (goal.id != 0 || !goal.label.empty()) {
    const std::optional<core::Place> place =
        goal.id != 0 ? memory.place(goal.id) : memory.place(goal.label);
    if (place) return core::RouteEnd{place->id, "", std::nullopt};
    result.status = GoToPlaceResult::UNKNOWN_GOAL;
    result.message = goal.id != 0 ? "there is no place " + std::to_string(goal.id)
                                  : "there is no place with the label that is given";
    return std::nullopt;
  }
  const std::string frame = support::withoutLeadingSlashes(goal.pose.header.frame_id);
  const core::Pose2d pose{goal.pose.pose.position.x, goal.pose.pose.position.y, 0.0};
  const bool is_near = std::max(std::abs(pose.x), std::abs(pose.y)) <= kFarthest;  // not for NaN
  if (pose.isFinite() && is_near && (frame.empty() || frame == map_frame)) {
    return core::RouteEnd{core::kNoPlace, "", pose};
  }
  result.status = GoToPlaceResult::INVALID_GOAL;
  result.message = "pose must be finite and on this earth, and in the frame \"" + map_frame + "\"";
  return std::nullopt;
}

bool isTaken(const ExploreGoal& goal, ExploreResult& result) {
  // Written so that NaN fails.
  if (goal.most_distance >= 0.0 && std::isfinite(goal.most_distance)) return true;
  result.status = ExploreResult::INVALID_GOAL;
  result.message = "most_distance must be a finite number of metres, or 0 for no bound";
  return false;
}

}  // namespace place_memory::node
