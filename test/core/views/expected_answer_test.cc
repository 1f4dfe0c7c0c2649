#include "core/views/expected_answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>

namespace place_memory::core {
namespace {

TEST(ExpectedAnswer, AViewThatPartsFourHasTwoBits) {
  const std::vector<double> even(4, 0.25);
  std::vector<std::vector<double>> parted(4, std::vector<double>(4, 1e-12));
  for (std::size_t i = 0; i < 4; ++i) parted[i][i] = 1.0;
  EXPECT_NEAR(entropyOf(even), 2.0, 1e-12);
  EXPECT_NEAR(expectedAnswer(even, parted).information, 2.0, 1e-6);
  EXPECT_NEAR(expectedAnswer(even, parted).probability, 1.0, 1e-6);
}

TEST(ExpectedAnswer, AViewThatPartsNothingTellsNothing) {
  const ExpectedAnswer answer = expectedAnswer({0.7, 0.2, 0.1}, {3, {0.4, 0.4, 0.4}});
  EXPECT_NEAR(answer.information, 0.0, 1e-12);
  EXPECT_NEAR(answer.probability, 0.7, 1e-12);
}

TEST(ExpectedAnswer, WhatIsPartedHalfIsWorthHalf) {
  // The first is parted from the other two, which stay alike.
  const ExpectedAnswer answer = expectedAnswer(
      {0.5, 0.25, 0.25}, {{1.0, 1e-12, 1e-12}, {1e-12, 1.0, 1.0}, {1e-12, 1.0, 1.0}});
  EXPECT_NEAR(answer.information, 1.0, 1e-6);
  EXPECT_NEAR(answer.probability, 0.75, 1e-6);
}

// Of views that are drawn as the likelihoods have it, by playing it through.
TEST(ExpectedAnswer, IsWhatPlayingItThroughGives) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> chance(0.05, 1.0);
  for (int round = 0; round < 20; ++round) {
    const std::size_t count = 2 + random() % 5;
    std::vector<double> probabilities(count);
    std::vector<std::vector<double>> likelihoods(count, std::vector<double>(count));
    double sum = 0.0;
    for (double& p : probabilities) sum += p = chance(random);
    for (double& p : probabilities) p /= sum;
    for (auto& row : likelihoods) {
      for (double& likelihood : row) likelihood = chance(random);
    }
    double left = 0.0, best = 0.0;
    for (std::size_t truth = 0; truth < count; ++truth) {
      std::vector<double> after;
      double all = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        after.push_back(probabilities[k] * likelihoods[truth][k]);
        all += after.back();
      }
      for (double& p : after) p /= all;
      left += probabilities[truth] * entropyOf(after);
      best += probabilities[truth] * *std::max_element(after.begin(), after.end());
    }
    const ExpectedAnswer answer = expectedAnswer(probabilities, likelihoods);
    EXPECT_NEAR(answer.information, std::max(entropyOf(probabilities) - left, 0.0), 1e-9);
    EXPECT_NEAR(answer.probability, best, 1e-9);
    EXPECT_LE(answer.information, entropyOf(probabilities) + 1e-9);
  }
}

}  // namespace
}  // namespace place_memory::core
