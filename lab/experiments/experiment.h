#ifndef PLACE_MEMORY_EXPERIMENTS_EXPERIMENT_H
#define PLACE_MEMORY_EXPERIMENTS_EXPERIMENT_H

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trial_runner.h"
#include "sim/world/world.h"

namespace place_memory::experiments {

/// One row of a table or one point of a curve.
struct Experiment {
  std::string group;  ///< "1" to "5", or what the row or curve is about
  std::string name;
  double x = 0.0;  ///< where a curve has its point
  /// Accuracy that the paper reports, by method.
  std::map<std::string, double> paper;
  bool has_laser = true;  ///< false: recorded readings, which no other sensor can repeat
  bool has_seeds = true;  ///< false: the same whatever the seed
  std::function<Batch(std::uint64_t seed, Sensor sensor)> make;
  std::function<std::vector<Answer>(const Batch&, const Method&)> run = runTrials;
};

struct ShippedWorlds {
  sim::World rooms;
  sim::World office;
  sim::World hallway;
};

/// Reads them from the folder. Throws sim::WorldError.
ShippedWorlds loadShippedWorlds(const std::string& folder);

/// The paper's experiments 1 to 5. The worlds must outlive the experiments, here and below.
std::vector<Experiment> paperExperiments(const ShippedWorlds& worlds);

/// Experiments 1, 3 and 4 with a robot that does not stand exactly where it learned, but three
/// inches off, as one that drives to a place or is put back on it.
std::vector<Experiment> putBackExperiments(const ShippedWorlds& worlds);

/// Generated buildings, each with a robot of its own: no shipped world, no paper.
Experiment buildingsExperiment();

/// Scans with little to go by (trials::simulateSparse): a row for each kind.
std::vector<Experiment> sparseExperiments();

/// Recorded scans (trials::readEpisodeFile), each of another building than the others: the scans of
/// one are strangers to the memory of another. Throws std::runtime_error.
std::vector<Experiment> recordedExperiments(const std::vector<std::string>& paths);

/// Names of the curves, in the order in which they are drawn.
std::vector<std::string> sweepNames();

/// The points of a curve. Throws std::runtime_error for a name that is none of sweepNames().
std::vector<Experiment> sweep(const std::string& name, const ShippedWorlds& worlds);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_EXPERIMENT_H
