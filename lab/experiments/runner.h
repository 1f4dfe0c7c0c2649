#ifndef PLACE_MEMORY_EXPERIMENTS_RUNNER_H
#define PLACE_MEMORY_EXPERIMENTS_RUNNER_H

#include <cstdint>
#include <functional>
#include <vector>

#include "experiments/experiment.h"

namespace place_memory::experiments {

struct RunOptions {
  std::uint64_t first_seed = kFirstReportedSeed;
  std::size_t seeds = 20;
  std::size_t slow_seeds = 2;  ///< seeds of the slow methods
  std::size_t threads = 2;     ///< >= 1
};

/// The answers of one method in one experiment, seed by seed.
struct Outcome {
  const Experiment* experiment = nullptr;
  const Method* method = nullptr;
  std::vector<Answer> answers;
  double seconds = 0.0;  ///< spent on recognition, learning included
};

/// Puts every experiment to every method, the experiments in the outer order. Answers are the same
/// for any number of threads. `progress` gets the jobs done and the jobs in all, one call at a
/// time. Throws what a job throws. Experiments and methods must outlive the outcomes.
std::vector<Outcome> runExperiments(const std::vector<Experiment>& experiments,
                                    const std::vector<Method>& methods, const RunOptions& options,
                                    const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_RUNNER_H
