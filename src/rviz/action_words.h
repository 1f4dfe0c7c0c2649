#ifndef PLACE_MEMORY_RVIZ_ACTION_WORDS_H
#define PLACE_MEMORY_RVIZ_ACTION_WORDS_H

#include <place_memory/ScanPlaceFeedback.h>

namespace place_memory::panel {

/// How much of a goal is done, in [0, 1].
inline double fractionOf(const ScanPlaceFeedback& feedback) { return feedback.fraction; }

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_ACTION_WORDS_H
