#ifndef PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H
#define PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H

#include <vector>

#include "experiments/answer.h"
#include "experiments/batch.h"
#include "experiments/method.h"

namespace place_memory::experiments {

/// Learns the batch's places and puts every trial to them: the known in order, then the strangers.
/// Grids have the batch's cell size, whatever the method's parameters say of it.
std::vector<Answer> runTrials(const Batch& batch, const Method& method);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H
