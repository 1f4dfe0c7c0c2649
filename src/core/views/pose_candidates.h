#ifndef PLACE_MEMORY_CORE_VIEWS_POSE_CANDIDATES_H
#define PLACE_MEMORY_CORE_VIEWS_POSE_CANDIDATES_H

#include <vector>

#include "core/views/view_advice.h"

namespace place_memory::core {

/// Neighbouring places see the robot at one spot: takes those that do for one candidate, leaves out
/// what is hardly probable, and makes the probabilities sum up to 1. The likeliest first.
std::vector<PoseCandidate> mergedCandidates(std::vector<PoseCandidate> candidates);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VIEWS_POSE_CANDIDATES_H
