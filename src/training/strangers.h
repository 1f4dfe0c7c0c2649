#ifndef PLACE_MEMORY_TRAINING_STRANGERS_H
#define PLACE_MEMORY_TRAINING_STRANGERS_H

#include <vector>

#include "training/candidates.h"

namespace place_memory::training {

/// The same scans as if the places nearer than `distance` [m] had never been learned.
std::vector<CandidateList> withoutNearPlaces(const trials::TrialSet& set,
                                             const std::vector<CandidateList>& lists,
                                             double distance);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_STRANGERS_H
