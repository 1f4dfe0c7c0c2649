#include "experiments/runner.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "support/parallel_for.h"

namespace place_memory::experiments {
namespace {

/// One experiment at one seed: its batch serves every method.
struct Job {
  const Experiment* experiment;
  std::size_t seed_index;
  std::uint64_t seed;
  std::vector<Outcome> outcomes;  ///< by method
};

bool takesPart(const Method& method, const Job& job, const RunOptions& options) {
  if (method.slow && job.seed_index >= options.slow_seeds) return false;
  return method.sensor == Sensor::kSonar || job.experiment->has_laser;
}

void perform(Job& job, const std::vector<Method>& methods, const RunOptions& options) {
  std::map<Sensor, Batch> batches;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Method& method = methods[m];
    if (!takesPart(method, job, options)) continue;
    if (batches.count(method.sensor) == 0) {
      batches[method.sensor] = job.experiment->make(job.seed, method.sensor);
    }
    const auto begin = std::chrono::steady_clock::now();
    Outcome& outcome = job.outcomes[m];
    outcome.answers = job.experiment->run(batches[method.sensor], method);
    for (Answer& answer : outcome.answers) answer.seed = job.seed;
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
}

std::vector<Job> listJobs(const std::vector<Experiment>& experiments, std::size_t methods,
                          const RunOptions& options) {
  std::vector<Job> jobs;
  for (const Experiment& experiment : experiments) {
    const std::size_t seeds = experiment.has_seeds ? options.seeds : 1;
    for (std::size_t i = 0; i < seeds; ++i) {
      jobs.push_back({&experiment, i, options.first_seed + i, std::vector<Outcome>(methods)});
    }
  }
  return jobs;
}

}  // namespace

std::vector<Outcome> runExperiments(const std::vector<Experiment>& experiments,
                                    const std::vector<Method>& methods, const RunOptions& options,
                                    const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Job> jobs = listJobs(experiments, methods.size(), options);
  support::parallelFor(
      jobs.size(), [&](std::size_t i) { perform(jobs[i], methods, options); }, options.threads,
      [&](std::size_t done) { progress(done, jobs.size()); });
  std::vector<Outcome> outcomes;
  for (const Experiment& experiment : experiments) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      Outcome outcome{&experiment, &methods[m], {}, 0.0};
      for (Job& job : jobs) {
        if (job.experiment != &experiment) continue;
        std::vector<Answer>& answers = job.outcomes[m].answers;
        std::move(answers.begin(), answers.end(), std::back_inserter(outcome.answers));
        outcome.seconds += job.outcomes[m].seconds;
      }
      if (!outcome.answers.empty()) outcomes.push_back(std::move(outcome));
    }
  }
  return outcomes;
}

}  // namespace place_memory::experiments
