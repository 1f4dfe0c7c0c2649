#ifndef PLACE_MEMORY_RVIZ_ACTION_WORDS_H
#define PLACE_MEMORY_RVIZ_ACTION_WORDS_H

#include <place_memory/ExploreFeedback.h>
#include <place_memory/GoToPlaceFeedback.h>
#include <place_memory/ScanPlaceFeedback.h>

#include "rviz/goal_progress.h"

namespace place_memory::panel {

/// What the feedback of each action says of how far it is.
GoalProgress progressOf(const ScanPlaceFeedback& feedback);
GoalProgress progressOf(const GoToPlaceFeedback& feedback);
GoalProgress progressOf(const ExploreFeedback& feedback);

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_ACTION_WORDS_H
