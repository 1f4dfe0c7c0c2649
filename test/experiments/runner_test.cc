#include "experiments/runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/answer_table.h"

namespace place_memory::experiments {
namespace {

const ShippedWorlds& worlds() {
  static const ShippedWorlds kWorlds =
      loadShippedWorlds(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds");
  return kWorlds;
}

std::vector<Experiment> inRooms() {
  std::vector<Experiment> experiments = paperExperiments(worlds());
  experiments.resize(2);
  return experiments;
}

std::vector<Method> methods(const std::vector<std::string>& names) {
  return selectMethods(allMethods({}, ""), names);
}

void ignore(std::size_t /*done*/, std::size_t /*total*/) {}

std::string resultsWith(std::size_t threads) {
  RunOptions options;
  options.seeds = 2;
  options.threads = threads;
  const auto experiments = inRooms();
  const auto compared = methods({"nearest_neighbour", "hill_climbing", "default_laser"});
  std::ostringstream text;
  answerTable(runExperiments(experiments, compared, options, ignore)).writeCsv(text);
  return text.str();
}

TEST(Runner, ResultsAreTheSameForAnyNumberOfThreads) {
  const std::string one = resultsWith(1);
  EXPECT_GT(one.size(), 1000U);
  EXPECT_EQ(one, resultsWith(3));
}

TEST(Runner, SlowMethodsRunOnTheFirstSeedsAlone) {
  RunOptions options;
  options.seeds = 2;
  options.slow_seeds = 1;
  auto experiments = inRooms();
  experiments.resize(1);
  auto compared = methods({"nearest_neighbour", "hill_climbing"});
  compared[1].slow = true;
  const auto outcomes = runExperiments(experiments, compared, options, ignore);
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_EQ(outcomes[0].answers.size(), 2 * outcomes[1].answers.size());
  EXPECT_EQ(outcomes[1].answers.back().seed, options.first_seed);
}

TEST(Runner, ReportsEveryJob) {
  RunOptions options;
  options.seeds = 2;
  const auto experiments = inRooms();
  const auto compared = methods({"nearest_neighbour"});
  std::vector<std::size_t> seen;
  runExperiments(experiments, compared, options, [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 4U);
    seen.push_back(done);
  });
  EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST(Runner, PassesOnWhatAnExperimentThrows) {
  Experiment broken;
  broken.make = [](std::uint64_t, Sensor) -> Batch { throw std::runtime_error("no world"); };
  const auto compared = methods({"nearest_neighbour"});
  EXPECT_THROW(runExperiments({broken}, compared, RunOptions{}, ignore), std::runtime_error);
}

/// A room of whose places one is scanned again a little off, without noise in between.
Batch oneRoom() {
  trials::Recipe recipe;
  recipe.shift = 0.3;
  recipe.compass_error = 0.1;
  return simulateBatch(worlds().rooms, {}, recipe, Sensor::kSonar, kFirstReportedSeed, 3);
}

TEST(TrialRunner, AnswersKnownPlacesFirstAndThenStrangers) {
  const auto answers = runTrials(oneRoom(), methods({"default"}).at(0));
  ASSERT_EQ(answers.size(), 8U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].known, i < 5);
    EXPECT_EQ(answers[i].right, i < 5 && answers[i].given == answers[i].expected);
    EXPECT_EQ(std::isnan(answers[i].position_error), !answers[i].right);
  }
}

TEST(TrialRunner, NearestNeighbourIsOffByTheShiftAndTheCompass) {
  const Batch batch = oneRoom();
  const auto answers = runTrials(batch, methods({"nearest_neighbour"}).at(0));
  int right = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    if (!answers[i].right) continue;
    ++right;
    EXPECT_NEAR(answers[i].position_error, 0.3, 1e-6);
    EXPECT_NEAR(answers[i].heading_error, std::abs(batch.known.trials[i].map_from_scan.yaw), 1e-9);
  }
  EXPECT_GT(right, 0);
}

TEST(TrialRunner, AnEmptyMemoryAnswersNothing) {
  Batch batch = oneRoom();
  batch.known.learned.clear();
  for (const Answer& answer : runTrials(batch, methods({"default"}).at(0))) {
    EXPECT_EQ(answer.given, "");
    EXPECT_FALSE(answer.right);
    EXPECT_EQ(answer.verdict, core::Verdict::kUnknown);
  }
}

}  // namespace
}  // namespace place_memory::experiments
