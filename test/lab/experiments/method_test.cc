#include "experiments/method.h"

#include <gtest/gtest.h>

#include <fstream>

#include "place_memory/config/parameter_error.h"

namespace place_memory::experiments {
namespace {

Method find(const std::string& name, const std::vector<std::string>& files = {},
            const std::string& preset = {}) {
  return selectMethods(allMethods(files, preset), {name}).at(0);
}

std::string fileWith(const std::string& text) {
  const std::string path = testing::TempDir() + "/method_test.yaml";
  std::ofstream(path) << text;
  return path;
}

TEST(Methods, ThePapersHaveThePapersPreset) {
  for (const char* name : {"nearest_neighbour", "hill_climbing", "hill_climbing_restarts"}) {
    EXPECT_EQ(find(name).parameters.match.preset, "paper");
  }
  EXPECT_EQ(find("nearest_neighbour").parameters.match.recognizer.method,
            core::SearchMethod::kNearestNeighbour);
  EXPECT_EQ(find("hill_climbing").parameters.match.recognizer.method,
            core::SearchMethod::kHillClimbing);
}

TEST(Methods, TheDefaultIsWhatThePackageShips) {
  const config::Parameters shipped;
  const Method method = find("default");
  EXPECT_EQ(method.parameters.match.preset, shipped.match.preset);
  EXPECT_EQ(method.parameters.match.recognizer.method, shipped.match.recognizer.method);
}

TEST(Methods, VariantsOfTheDefaultKeepItsPreset) {
  const std::string preset = find("default").parameters.match.preset;
  EXPECT_EQ(find("default_exhaustive").parameters.match.preset, preset);
  EXPECT_EQ(find("default_exhaustive").parameters.match.recognizer.method,
            core::SearchMethod::kExhaustive);
  EXPECT_EQ(find("default_single_climb").parameters.match.preset, preset);
  EXPECT_EQ(find("default_laser").parameters.match.preset, preset);
  EXPECT_EQ(find("default_laser").sensor, Sensor::kLaser);
}

TEST(Methods, ParameterFilesHoldForAllWhileThePapersKeepTheirPreset) {
  const std::string file = fileWith("match: {position_window: 0.7, preset: evidence}\n");
  EXPECT_EQ(find("default", {file}).parameters.match.recognizer.position_window, 0.7);
  EXPECT_EQ(find("hill_climbing", {file}).parameters.match.recognizer.position_window, 0.7);
  EXPECT_EQ(find("hill_climbing", {file}).parameters.match.preset, "paper");
}

TEST(Methods, APresetGoesBeforeTheFiles) {
  const std::string file = fileWith("match: {preset: evidence}\n");
  EXPECT_EQ(find("default", {file}, "paper").parameters.match.preset, "paper");
}

TEST(Methods, WrongParametersAreRefused) {
  EXPECT_THROW(allMethods({fileWith("match: {position_window: -1}\n")}, ""),
               config::ParameterError);
  EXPECT_THROW(allMethods({"/no/such/file.yaml"}, ""), config::ParameterError);
  EXPECT_THROW(allMethods({}, "/no/such/preset.yaml"), config::ParameterError);
}

TEST(Methods, AnUnknownNameIsRefused) {
  EXPECT_THROW(selectMethods(allMethods({}, ""), {"magic"}), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::experiments
