#ifndef PLACE_MEMORY_TRAINING_STRANGERS_H
#define PLACE_MEMORY_TRAINING_STRANGERS_H

#include <vector>

#include "training/candidates.h"

namespace place_memory::training {

/// The same scans as if the places nearer than `distance` [m] had never been learned.
std::vector<CandidateList> withoutNearPlaces(const trials::TrialSet& set,
                                             const std::vector<CandidateList>& lists,
                                             double distance);

/// Every tenth list as it would be in a memory of one to four places: the first candidate that is
/// right, where there is one, and others drawn at random. The same lists give the same.
std::vector<CandidateList> amongFewPlaces(const std::vector<CandidateList>& lists);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_STRANGERS_H
