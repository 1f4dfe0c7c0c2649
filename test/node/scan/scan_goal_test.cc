#include "node/scan/scan_goal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

TEST(ReadGoal, ParametersStandInForWhatIsLeftOpen) {
  config::ScanOptions defaults;
  defaults.headings = 7;
  defaults.step = 0.1;
  defaults.timeout = 12.0;
  defaults.turn = config::Turn::kCmdVel;
  std::string problem;
  const auto request = readGoal(ScanPlaceGoal(), defaults, problem);
  ASSERT_TRUE(request) << problem;
  EXPECT_EQ(request->headings, 7);
  EXPECT_EQ(request->step, 0.1);
  EXPECT_EQ(request->timeout, 12.0);
  EXPECT_EQ(request->turn, config::Turn::kCmdVel);
}

TEST(ReadGoal, TakesWhatIsGiven) {
  ScanPlaceGoal goal;
  goal.headings = 72;
  goal.step = 0.0873;
  goal.turn = ScanPlaceGoal::TURN_CMD_VEL;
  goal.timeout = ros::Duration(5.0);
  std::string problem;
  const auto request = readGoal(goal, config::ScanOptions(), problem);
  ASSERT_TRUE(request) << problem;
  EXPECT_EQ(request->headings, 72);
  EXPECT_EQ(request->step, 0.0873);
  EXPECT_EQ(request->turn, config::Turn::kCmdVel);
  EXPECT_EQ(request->timeout, 5.0);
}

void expectRefused(const ScanPlaceGoal& goal, const std::string& field) {
  std::string problem;
  EXPECT_FALSE(readGoal(goal, config::ScanOptions(), problem)) << field;
  EXPECT_NE(problem.find(field), std::string::npos) << problem;
}

TEST(ReadGoal, RefusesEachFieldOutOfRange) {
  ScanPlaceGoal goal;
  goal.headings = 3601;
  expectRefused(goal, "headings");
  goal = ScanPlaceGoal();
  for (const double step :
       {-0.1, 1e-9, 3.2, std::nan(""), std::numeric_limits<double>::infinity()}) {
    goal.step = step;
    expectRefused(goal, "step");
  }
  goal = ScanPlaceGoal();
  goal.turn = 3;
  expectRefused(goal, "turn");
  goal = ScanPlaceGoal();
  for (const double timeout : {-1.0, 3601.0}) {
    goal.timeout = ros::Duration(timeout);
    expectRefused(goal, "timeout");
  }
}

TEST(ToMessage, HoldsTheCountsThatAreNotZero) {
  RejectCounts counts{};
  counts[static_cast<std::size_t>(Reject::kNan)] = 3;
  counts[static_cast<std::size_t>(Reject::kNoHeading)] = 1;
  const auto messages = toMessage(counts);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].reason, "range is NaN");
  EXPECT_EQ(messages[0].count, 3U);
  EXPECT_EQ(messages[1].reason, "no heading");
}

}  // namespace
}  // namespace place_memory::node
