#include "experiments/runner.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  ASSERT_EQ(answers.size(), 11U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].known, i < 5);
    EXPECT_EQ(answers[i].stranger, i >= 5 && i < 8);
    EXPECT_EQ(answers[i].right, i < 5 && answers[i].given == answers[i].expected);
    EXPECT_EQ(std::isnan(answers[i].position_error), !answers[i].right);
  }
}

TEST(TrialRunner, WhatCountsAsNeverLearnedIsNotAnsweredWithPlacesThatAreNear) {
  Batch batch = simulateBatch(worlds().hallway, {}, trials::Recipe{}, Sensor::kSonar, 1, 0);
  batch.unlearned = batch.known.trials.size();
  const auto answers = runTrials(batch, methods({"nearest_neighbour"}).at(0));
  ASSERT_EQ(answers.size(), 2 * batch.unlearned);
  for (std::size_t i = 0; i < batch.unlearned; ++i) {
    const Answer& answer = answers[batch.unlearned + i];
    const auto given = std::find_if(batch.known.learned.begin(), batch.known.learned.end(),
                                    [&](const auto& scan) { return scan.label == answer.given; });
    ASSERT_NE(given, batch.known.learned.end());
    const core::Pose2d& truth = batch.known.trials[i].odom_from_scan;
    EXPECT_GE(std::hypot(given->odom_from_scan.x - truth.x, given->odom_from_scan.y - truth.y),
              kNear);
    EXPECT_FALSE(answer.known || answer.right || answer.stranger);
  }
}

TEST(Judge, NormalisesTheErrorOfThePoseByItsCovariance) {
  trials::RecognitionTrial trial;
  trial.accept = {"a"};
  trial.odom_from_scan = {1.0, 2.0, core::kPi - 0.1};
  core::Recognition found;
  found.matches = {{1, 10.0, {}, 0.9}};
  found.map_from_robot = {1.2, 1.9, -core::kPi + 0.1};
  // Errors of 0.2 m, -0.1 m and 0.2 rad, the first two correlated.
  found.covariance = {0.04, 0.01, 0.0, 0.01, 0.02, 0.0, 0.0, 0.0, 0.01};
  const Answer answer = judge(trial, found, "a");
  EXPECT_NEAR(answer.position_error, std::hypot(0.2, 0.1), 1e-9);
  EXPECT_NEAR(answer.heading_error, 0.2, 1e-9);
  const double position = (0.02 * 0.04 + 0.04 * 0.01 + 2.0 * 0.01 * 0.02) / (0.04 * 0.02 - 0.0001);
  EXPECT_NEAR(answer.normalised_error, position + 4.0, 1e-9);
  EXPECT_TRUE(std::isnan(judge(trial, found, "b").normalised_error));
  EXPECT_NEAR(judge(trial, found, "b").distance, std::hypot(0.2, 0.1), 1e-9);
}

TEST(TrialRunner, NearestNeighbourIsOffByTheShiftAndTheCompass) {
  const Batch batch = oneRoom();
  const auto answers = runTrials(batch, methods({"nearest_neighbour"}).at(0));
  int right = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    if (!answers[i].right) continue;
    ++right;
    EXPECT_NEAR(answers[i].position_error, 0.3, 1e-6);
    EXPECT_NEAR(answers[i].heading_error, std::abs(batch.known.trials[i].odom_from_scan.yaw), 1e-9);
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
