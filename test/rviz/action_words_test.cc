#include "rviz/action_words.h"

#include <gtest/gtest.h>

#include <limits>

namespace place_memory::panel {
namespace {

TEST(ActionWords, AScanSaysWhichFractionIsDone) {
  ScanPlaceFeedback feedback;
  feedback.fraction = 0.5;
  feedback.message = "turn on";
  const GoalProgress progress = progressOf(feedback);
  EXPECT_EQ(progress.fraction, 0.5);
  EXPECT_EQ(progress.message, "turn on");
}

TEST(ActionWords, ADriveSaysWhichLegAndWhatIsLeft) {
  GoToPlaceFeedback feedback;
  feedback.leg = "hall to kitchen";
  feedback.message = "waits for what stands in its way";
  feedback.legs_left = 1;
  feedback.time_left = 12.4;
  const GoalProgress progress = progressOf(feedback);
  EXPECT_FALSE(progress.fraction.has_value());
  EXPECT_EQ(progress.time_left, 12.4);
  EXPECT_EQ(progress.message,
            "hall to kitchen; waits for what stands in its way; 1 leg and some 12 s left");
}

TEST(ActionWords, ATimeThatIsNoneIsNotSaid) {
  GoToPlaceFeedback feedback;
  feedback.message = "goes";
  for (const double none :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), -1.0}) {
    feedback.time_left = none;
    EXPECT_FALSE(progressOf(feedback).time_left.has_value());
    EXPECT_EQ(progressOf(feedback).message, "goes");
  }
}

TEST(ActionWords, ExploringSaysWhatItFoundSoFar) {
  ExploreFeedback feedback;
  feedback.message = "drives on";
  feedback.places = 7;
  feedback.frontiers = 1;
  feedback.distance = 41.7;
  EXPECT_EQ(progressOf(feedback).message,
            "drives on; 7 places made, 1 opening to be seen, 42 m driven");
  EXPECT_FALSE(progressOf(feedback).fraction.has_value());
  feedback.distance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(progressOf(feedback).message, "drives on; 7 places made, 1 opening to be seen");
}

}  // namespace
}  // namespace place_memory::panel
