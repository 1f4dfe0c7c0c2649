#include "trials/simulated_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/scene/world_loader.h"

namespace place_memory::trials {
namespace {

const sim::World& world(const std::string& name) {
  static std::map<std::string, sim::World> worlds;
  if (worlds.count(name) == 0) {
    worlds[name] =
        sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/" + name + ".yaml");
  }
  return worlds[name];
}

Recipe everythingChanges() {
  Recipe recipe;
  recipe.chairs_about_place = 2;
  recipe.doors_flipped = 0.5;
  recipe.chairs_moved = 0.5;
  recipe.people = 2;
  recipe.shift = 0.6;
  recipe.compass_error = 0.2;
  recipe.readings_lost = 0.3;
  return recipe;
}

TrialSet roomTrials(const Recipe& recipe, std::uint64_t seed) {
  return simulateTrials(world("rooms"), sim::SimulatedRobot{}, recipe, seed);
}

bool same(const std::vector<core::SonarReading>& a, const std::vector<core::SonarReading>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const auto& left, const auto& right) {
        return left.range == right.range && left.sensor_pose.x == right.sensor_pose.x &&
               left.sensor_pose.yaw == right.sensor_pose.yaw;
      });
}

double distance(const core::Pose2d& a, const core::Pose2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(SimulatedTrials, TheSameSeedGivesTheSameTrials) {
  const TrialSet once = roomTrials(everythingChanges(), 5);
  const TrialSet again = roomTrials(everythingChanges(), 5);
  ASSERT_EQ(once.learned.size(), 5U);
  ASSERT_EQ(once.trials.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(same(once.learned[i].readings, again.learned[i].readings));
    EXPECT_TRUE(same(once.trials[i].readings, again.trials[i].readings));
    EXPECT_EQ(distance(once.trials[i].odom_from_scan, again.trials[i].odom_from_scan), 0.0);
  }
}

TEST(SimulatedTrials, AnotherSeedGivesOthers) {
  const TrialSet one = roomTrials(everythingChanges(), 5);
  const TrialSet other = roomTrials(everythingChanges(), 6);
  EXPECT_FALSE(same(one.learned[0].readings, other.learned[0].readings));
  EXPECT_FALSE(same(one.trials[0].readings, other.trials[0].readings));
}

TEST(SimulatedTrials, WhatChangesLaterChangesNothingThatWasLearned) {
  Recipe later = everythingChanges();
  later.people = 0;
  later.readings_lost = 0.0;
  const TrialSet changed = roomTrials(later, 5);
  const TrialSet still = roomTrials(Recipe{}, 5);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(same(changed.learned[i].readings, still.learned[i].readings));
    EXPECT_FALSE(same(changed.trials[i].readings, still.trials[i].readings));
  }
}

TEST(SimulatedTrials, ShiftsAreAsFarAsAsked) {
  Recipe recipe;
  recipe.shift = 0.6;
  const TrialSet set = roomTrials(recipe, 1);
  for (std::size_t i = 0; i < set.trials.size(); ++i) {
    EXPECT_NEAR(distance(set.trials[i].odom_from_scan, set.learned[i].odom_from_scan), 0.6, 1e-9);
    EXPECT_EQ(set.trials[i].accept, std::vector<std::string>{set.learned[i].label});
  }
}

TEST(SimulatedTrials, ShiftsAlongLinksStayOnTheHallwaysAxis) {
  Recipe recipe;
  recipe.shift = 0.6;
  recipe.shift_along_links = true;
  const sim::World& hallway = world("hallway");
  const TrialSet set = simulateTrials(hallway, sim::SimulatedRobot{}, recipe, 1);
  for (std::size_t i = 0; i < set.trials.size(); ++i) {
    EXPECT_NEAR(set.trials[i].odom_from_scan.y, hallway.places[i].position.y, 0.1);
    EXPECT_FALSE(set.trials[i].accept.empty());
  }
}

TEST(SimulatedTrials, DriftTurnsTheEndsOfTheWorldOppositeWays) {
  Recipe recipe;
  recipe.drift = 0.5;
  const TrialSet set = simulateTrials(world("hallway"), sim::SimulatedRobot{}, recipe, 1);
  EXPECT_NEAR(set.learned.front().odom_from_scan.yaw, 0.5, 1e-9);
  EXPECT_NEAR(set.learned.back().odom_from_scan.yaw, -0.5, 1e-9);
}

TEST(SimulatedTrials, LostReadingsAreGone) {
  Recipe recipe;
  recipe.readings_lost = 0.5;
  const std::size_t all = roomTrials(Recipe{}, 1).trials[0].readings.size();
  const std::size_t left = roomTrials(recipe, 1).trials[0].readings.size();
  EXPECT_GT(left, all / 4);
  EXPECT_LT(left, all * 3 / 4);
  recipe.readings_lost = 1.0;
  EXPECT_TRUE(roomTrials(recipe, 1).trials[0].readings.empty());
}

TEST(SimulatedTrials, ALaserTakesThePlaceOfTheSonars) {
  Recipe recipe;
  recipe.laser = sim::LaserModel{};
  recipe.people = 1;
  const TrialSet set = roomTrials(recipe, 1);
  for (const LearnedScan& scan : set.learned) {
    EXPECT_GT(scan.readings.size(), 350U);
    EXPECT_NEAR(scan.readings[0].spec.field_of_view, 2.0 * core::kPi / 360.0, 1e-9);
  }
}

TEST(SimulatedRounds, TheFirstIsTheOnlyOneOfOtherTrials) {
  const TrialSet once = roomTrials(everythingChanges(), 5);
  const TrialSet rounds =
      simulateRounds(world("rooms"), sim::SimulatedRobot{}, everythingChanges(), 3, 5);
  ASSERT_EQ(rounds.trials.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(rounds.trials[i].round, static_cast<int>(i / 5));
    EXPECT_EQ(same(rounds.trials[i].readings, once.trials[i % 5].readings), i < 5);
  }
}

/// Share of the readings of a round that are not as they were when the place was learned.
double changedShare(const TrialSet& set, int round) {
  int all = 0;
  int changed = 0;
  for (std::size_t i = 0; i < set.trials.size(); ++i) {
    if (set.trials[i].round != round) continue;
    const auto& before = set.learned[i % set.learned.size()].readings;
    const auto& after = set.trials[i].readings;
    for (std::size_t j = 0; j < std::min(before.size(), after.size()); ++j) {
      ++all;
      const bool same_kind = std::isfinite(before[j].range) == std::isfinite(after[j].range);
      if (!same_kind || std::abs(before[j].range - after[j].range) > 0.3) ++changed;
    }
  }
  return static_cast<double>(changed) / all;
}

TEST(SimulatedRounds, ChangesAddUp) {
  Recipe recipe;
  recipe.furniture_moved = 0.2;
  recipe.chairs_moved = 0.2;
  const TrialSet set = simulateRounds(world("office"), sim::SimulatedRobot{}, recipe, 6, 1);
  EXPECT_GT(changedShare(set, 5), 1.5 * changedShare(set, 0));
}

TEST(SimulatedTrials, NothingIsRightForAStranger) {
  const auto strangers =
      simulateStrangers(world("rooms"), sim::SimulatedRobot{}, everythingChanges(), 1);
  ASSERT_EQ(strangers.size(), 5U);
  for (const RecognitionTrial& trial : strangers) EXPECT_TRUE(trial.accept.empty());
}

TEST(SimulatedVisits, GoFromPlaceToPlaceAlongTheLinks) {
  Recipe recipe;
  recipe.shift = 0.4;
  recipe.heading_spread = 0.5;
  const sim::World& hallway = world("hallway");
  const TrialSet set = simulateVisits(hallway, sim::SimulatedRobot{}, recipe, 30, 3);
  EXPECT_EQ(set.learned.size(), hallway.places.size());
  ASSERT_EQ(set.trials.size(), 30U);
  const auto neighbours = sim::placeNeighbours(hallway);
  const auto placeOf = [&](const RecognitionTrial& trial) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < set.learned.size(); ++i) {
      const core::Pose2d& best = set.learned[nearest].odom_from_scan;
      const core::Pose2d& other = set.learned[i].odom_from_scan;
      if (distance(other, trial.odom_from_scan) < distance(best, trial.odom_from_scan)) nearest = i;
    }
    return nearest;
  };
  for (std::size_t i = 1; i < set.trials.size(); ++i) {
    const std::size_t from = placeOf(set.trials[i - 1]), to = placeOf(set.trials[i]);
    EXPECT_EQ(std::count(neighbours[from].begin(), neighbours[from].end(), to), 1) << i;
    core::Pose2d before = set.trials[i - 1].way.back();
    for (const core::Pose2d& pose : set.trials[i].way) {
      EXPECT_LT(distance(before, pose), 0.36);
      before = pose;
    }
    EXPECT_NEAR(distance(before, set.trials[i].odom_from_scan), 0.0, 1e-9);
  }
  const TrialSet again = simulateVisits(hallway, sim::SimulatedRobot{}, recipe, 30, 3);
  EXPECT_TRUE(same(set.trials[29].readings, again.trials[29].readings));
}

}  // namespace
}  // namespace place_memory::trials
