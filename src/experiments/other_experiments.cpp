#include "experiments/experiment.h"
#include "experiments/recipes.h"
#include "place_memory/sim/building_generator.h"
#include "place_memory/sim/random_robot.h"
#include "trials/episode_file.h"

namespace place_memory::experiments {
namespace {

constexpr std::size_t kTrials = 24;
constexpr std::size_t kStrangers = 12;
constexpr std::size_t kRecordedUnlearned = 200;

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

Experiment recordedExperiment(const std::string& path) {
  Experiment experiment;
  experiment.group = "recorded";
  const trials::TrialSet recorded = trials::readEpisodeFile(path);
  experiment.name = recorded.name;
  experiment.has_laser = false;
  experiment.has_seeds = false;
  experiment.make = [recorded](std::uint64_t /*seed*/, Sensor /*sensor*/) {
    return Batch{recorded, {}, kRecordedUnlearned};
  };
  return experiment;
}

}  // namespace place_memory::experiments
