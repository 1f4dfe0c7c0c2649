#include "experiments/experiment.h"
#include "experiments/recipes.h"
#include "sim/building/building_generator.h"
#include "sim/robot/random_robot.h"
#include "trials/episode_file.h"
#include "trials/sparse_trials.h"

namespace place_memory::experiments {
namespace {

constexpr std::size_t kTrials = 24;
constexpr std::size_t kStrangers = 12;
constexpr std::size_t kRecordedUnlearned = 200;
constexpr std::size_t kRecordedStrangers = 200;

/// The learned scans of the next recording, round and round, with the same cells; none where there
/// is no such.
std::vector<trials::RecognitionTrial> recordedStrangers(
    const std::vector<trials::TrialSet>& recorded, std::size_t memory) {
  const double window = recorded[memory].trials.front().heading_window;
  std::vector<trials::RecognitionTrial> strangers;
  for (std::size_t step = 1; step < recorded.size(); ++step) {
    const trials::TrialSet& elsewhere = recorded[(memory + step) % recorded.size()];
    if (elsewhere.cell_size != recorded[memory].cell_size) continue;
    for (const trials::LearnedScan& scan : elsewhere.learned) {
      strangers.push_back({{}, scan.odom_from_scan, window, scan.readings});
    }
    break;
  }
  thinOut(strangers, kRecordedStrangers);
  return strangers;
}

}  // namespace

Experiment buildingsExperiment() {
  Experiment experiment;
  experiment.group = "buildings";
  experiment.name = "generated building, random robot";
  experiment.make = [](std::uint64_t seed, Sensor sensor) {
    const sim::SimulatedRobot robot = sim::randomRobot(kFirstReportedBuilding + seed);
    // Not the building that strangers of this seed come from.
    Batch batch = simulateBatch(reportedBuilding(seed + kFirstReportedBuilding), robot,
                                buildingRecipe(), sensor, seed, kStrangers);
    thinOut(batch.known.trials, kTrials);
    return batch;
  };
  return experiment;
}

std::vector<Experiment> sparseExperiments() {
  std::vector<Experiment> experiments;
  for (const trials::SparseKind kind : trials::kEverySparseKind) {
    Experiment experiment;
    experiment.group = "sparse";
    experiment.name = trials::nameOf(kind);
    experiment.has_laser = false;
    experiment.make = [kind](std::uint64_t seed, Sensor /*sensor*/) {
      const trials::SparseTrials made = trials::simulateSparse(kind, seed);
      return Batch{made.known, made.strangers, kStrangers};
    };
    experiments.push_back(std::move(experiment));
  }
  return experiments;
}

std::vector<Experiment> recordedExperiments(const std::vector<std::string>& paths) {
  std::vector<trials::TrialSet> recorded;
  recorded.reserve(paths.size());
  for (const std::string& path : paths) recorded.push_back(trials::readEpisodeFile(path));
  std::vector<Experiment> experiments;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    Experiment experiment;
    experiment.group = "recorded";
    experiment.name = recorded[i].name;
    experiment.has_laser = false;
    experiment.has_seeds = false;
    Batch batch{recorded[i], recordedStrangers(recorded, i), kRecordedUnlearned};
    experiment.make = [batch](std::uint64_t /*seed*/, Sensor /*sensor*/) { return batch; };
    experiments.push_back(std::move(experiment));
  }
  return experiments;
}

}  // namespace place_memory::experiments
