#ifndef PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H
#define PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H

#include <vector>

#include "experiments/answer.h"
#include "experiments/batch.h"
#include "experiments/method.h"
#include "place_memory/core/recognition.h"

namespace place_memory::experiments {

/// The answer that a recognition is, `given` being the label of its best match, if there is one.
Answer judge(const trials::RecognitionTrial& trial, const core::Recognition& found,
             const std::string& given);

/// Learns the batch's places and puts every trial to them: the known in order, the strangers, and
/// the known as if they were never learned.
/// Grids have the batch's cell size, whatever the method's parameters say of it.
std::vector<Answer> runTrials(const Batch& batch, const Method& method);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_TRIAL_RUNNER_H
