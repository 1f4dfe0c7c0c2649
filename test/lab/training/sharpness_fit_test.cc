#include "training/sharpness_fit.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "place_memory/config/match_preset.h"
#include "sim/building/building_generator.h"
#include "trials/simulated_trials.h"

namespace place_memory::training {
namespace {

trials::TrialSet trialsIn(std::uint64_t seed) {
  trials::Recipe recipe;
  recipe.shift = 0.3;
  recipe.compass_error = 0.2;
  return trials::simulateTrials(sim::generateBuilding(sim::BuildingKind::kCorridor, seed), {},
                                recipe, seed);
}

double fit(const std::vector<trials::TrialSet>& sets) {
  return fitSharpness(sets, core::SonarModel{{}}, config::loadPreset("evidence").metric);
}

TEST(FitSharpness, PosesFurtherOffMakeItLess) {
  trials::TrialSet set = trialsIn(1);
  const double exact = fit({set});
  for (trials::RecognitionTrial& trial : set.trials) trial.odom_from_scan.x += 0.2;
  EXPECT_LT(fit({set}), 0.5 * exact);
}

TEST(FitSharpness, RobotsThatMisjudgeTheirTurnsDoNotCount) {
  const trials::TrialSet set = trialsIn(1);
  trials::TrialSet bent = trialsIn(2);
  for (trials::RecognitionTrial& trial : bent.trials) trial.odom_from_scan.x += 0.2;
  bent.turns_truly = false;
  EXPECT_EQ(fit({set, bent}), fit({set}));
}

TEST(FitSharpness, AlignmentsThatAreWrongDoNotCount) {
  trials::TrialSet set = trialsIn(1);
  const double all = fit({set});
  set.trials.push_back(set.trials.front());
  set.trials.back().odom_from_scan.x += 3.0;
  EXPECT_EQ(fit({set}), all);
}

TEST(FitSharpness, NothingToFitOnThrows) { EXPECT_THROW(fit({}), std::runtime_error); }

}  // namespace
}  // namespace place_memory::training
