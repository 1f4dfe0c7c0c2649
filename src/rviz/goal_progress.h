#ifndef PLACE_MEMORY_RVIZ_GOAL_PROGRESS_H
#define PLACE_MEMORY_RVIZ_GOAL_PROGRESS_H

#include <optional>
#include <string>

namespace place_memory::panel {

/// How far a goal is. Of a drive that explores nobody knows how long it takes.
struct GoalProgress {
  std::optional<double> fraction;   ///< that is done, in [0, 1]
  std::optional<double> time_left;  ///< [s]
  std::string message;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_GOAL_PROGRESS_H
