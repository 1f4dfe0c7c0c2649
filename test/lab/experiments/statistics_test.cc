#include "experiments/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::experiments {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Answer known(bool right, core::Verdict verdict, double probability) {
  Answer answer;
  answer.right = right;
  answer.verdict = verdict;
  answer.probability = probability;
  answer.position_error = right ? 0.1 : kNone;
  answer.normalised_error = right ? 3.0 : kNone;
  return answer;
}

Answer stranger(core::Verdict verdict, double probability) {
  Answer answer = known(false, verdict, probability);
  answer.known = false;
  answer.stranger = true;
  return answer;
}

TEST(WilsonInterval, AgreesWithPublishedValues) {
  // Newcombe (1998), table I: 81 of 263 and 0 of 20.
  EXPECT_NEAR(wilsonInterval(81, 263).low, 0.2553, 1e-4);
  EXPECT_NEAR(wilsonInterval(81, 263).high, 0.3662, 1e-4);
  EXPECT_EQ(wilsonInterval(0, 20).low, 0.0);
  EXPECT_NEAR(wilsonInterval(0, 20).high, 0.1611, 1e-4);
}

TEST(WilsonInterval, OfNoTrialsSaysNothing) {
  EXPECT_EQ(wilsonInterval(0, 0).low, 0.0);
  EXPECT_EQ(wilsonInterval(0, 0).high, 1.0);
}

TEST(ConsistencyBounds, AreThoseOfChiSquare) {
  // Chi square with 30 degrees of freedom: 16.791 and 46.979.
  EXPECT_NEAR(consistencyBounds(10).low, 1.6791, 1e-4);
  EXPECT_NEAR(consistencyBounds(10).high, 4.6979, 1e-4);
}

TEST(Summary, CountsVerdictsOfKnownPlacesAndOfStrangers) {
  const Summary summary = summarize(
      {known(true, core::Verdict::kRecognized, 0.95), known(true, core::Verdict::kAmbiguous, 0.55),
       known(false, core::Verdict::kRecognized, 0.85), stranger(core::Verdict::kUnknown, 0.05),
       stranger(core::Verdict::kRecognized, 0.95)});
  EXPECT_EQ(summary.known, 3U);
  EXPECT_EQ(summary.right, 2U);
  EXPECT_EQ(summary.recognized, 1U);
  EXPECT_EQ(summary.wrong, 1U);
  EXPECT_EQ(summary.strangers, 2U);
  EXPECT_EQ(summary.accepted, 1U);
  EXPECT_EQ(summary.posed, 1U) << "poses count where a robot would use them";
  EXPECT_DOUBLE_EQ(summary.normalised_error, 3.0);
}

TEST(Summary, PlacesNeverLearnedAreCountedApartFromOtherBuildings) {
  Answer unlearned = stranger(core::Verdict::kRecognized, 0.95);
  unlearned.stranger = false;
  const Summary summary =
      summarize({unlearned, unlearned, stranger(core::Verdict::kUnknown, 0.05)});
  EXPECT_EQ(summary.unlearned, 2U);
  EXPECT_EQ(summary.unlearned_accepted, 2U);
  EXPECT_EQ(summary.strangers, 1U);
  EXPECT_EQ(summary.accepted, 0U);
  EXPECT_EQ(summary.reliability[9].answers, 0U);
  EXPECT_EQ(summary.reliability[0].answers, 1U);
}

TEST(Summary, CalibrationErrorIsTheMeanGapOfTheTenths) {
  // 0.9 to 1: one of two right at 0.95, a gap of 0.45; 0.2 to 0.3: none of one at 0.25.
  const Summary summary = summarize({known(true, core::Verdict::kRecognized, 0.95),
                                     stranger(core::Verdict::kRecognized, 0.95),
                                     stranger(core::Verdict::kUnknown, 0.25)});
  EXPECT_NEAR(summary.calibration_error, (2 * 0.45 + 0.25) / 3.0, 1e-12);
  EXPECT_EQ(summary.reliability[9].answers, 2U);
  EXPECT_EQ(summary.reliability[2].right, 0U);
}

TEST(Summary, ACertainAnswerFallsIntoTheLastTenth) {
  EXPECT_EQ(summarize({known(true, core::Verdict::kRecognized, 1.0)}).reliability[9].right, 1U);
}

TEST(Summary, MeansOverNothingAreNotNumbers) {
  const Summary summary = summarize({});
  EXPECT_TRUE(std::isnan(summary.position_error));
  EXPECT_TRUE(std::isnan(summary.calibration_error));
  EXPECT_TRUE(std::isnan(summary.normalised_error));
}

TEST(Summary, AFootIsWithinAFoot) {
  Answer near = known(true, core::Verdict::kRecognized, 1.0);
  near.position_error = 0.3048;
  Answer far = near;
  far.position_error = 0.31;
  const Summary summary = summarize({near, far});
  EXPECT_DOUBLE_EQ(summary.within_foot, 0.5);
  EXPECT_NEAR(summary.position_error, 0.3074, 1e-9);
}

}  // namespace
}  // namespace place_memory::experiments
