#ifndef PLACE_MEMORY_TRAINING_TRAINING_WORLDS_H
#define PLACE_MEMORY_TRAINING_TRAINING_WORLDS_H

#include <cstdint>

#include "trials/trial_set.h"

namespace place_memory::training {

/// A random building, a random robot, and random changes between learning and coming back; the same
/// for the same seed. The kinds and the ranges are wide on purpose: what is fitted here is to hold
/// in buildings and on robots that nobody has simulated.
trials::TrialSet trainingSet(std::uint64_t seed);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_TRAINING_WORLDS_H
