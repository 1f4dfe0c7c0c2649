#include <actionlib_msgs/GoalStatus.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <gtest/gtest.h>

#include <string>

#include "rviz/panel_state_fixture.h"

namespace place_memory::panel {
namespace {

using PanelGoalsTest = PanelStateTest;
using actionlib_msgs::GoalStatus;

actionlib_msgs::GoalStatusArray listed(const std::string& id, unsigned char status,
                                       const std::string& text = "") {
  actionlib_msgs::GoalStatusArray statuses;
  statuses.status_list.resize(1);
  statuses.status_list[0].goal_id.id = id;
  statuses.status_list[0].status = status;
  statuses.status_list[0].text = text;
  return statuses;
}

TEST_F(PanelGoalsTest, AGoalIsUnderWayUntilItsResult) {
  state_.sendGoal("scan", "a", kNow);
  EXPECT_EQ(why(Command::kScan), "~scan is under way");
  state_.hearProgress("scan", "a", {0.25, {}, "turn on"}, kNow);
  EXPECT_EQ(state_.view().goals.at("scan").fraction, 0.25);
  EXPECT_EQ(state_.view().goals.at("scan").message, "turn on");
  state_.endGoal("scan", "a", "scan: 176 readings", false);
  EXPECT_EQ(why(Command::kScan), "");
  EXPECT_EQ(state_.view().note.text, "scan: 176 readings");
}

TEST_F(PanelGoalsTest, OfTheTimeThatADriveTakesThatIsDoneWhichIsNotLeft) {
  state_.sendGoal("go_to_place", "a", kNow);
  state_.hearProgress("go_to_place", "a", {{}, 40.0, ""}, kNow);
  EXPECT_EQ(state_.view().goals.at("go_to_place").fraction, 0.0);
  state_.hearProgress("go_to_place", "a", {{}, 10.0, ""}, kNow);
  EXPECT_EQ(state_.view().goals.at("go_to_place").fraction, 0.75);
  state_.hearProgress("go_to_place", "a", {{}, 80.0, ""}, kNow);  // a link was blocked
  EXPECT_EQ(state_.view().goals.at("go_to_place").fraction, 0.0);
  state_.hearProgress("go_to_place", "b", {{}, 20.0, ""}, kNow);
  EXPECT_EQ(state_.view().goals.at("go_to_place").fraction, 0.0) << "a new goal begins anew";
}

TEST_F(PanelGoalsTest, HowMuchOfAGoalIsDoneNeedNotBeKnown) {
  state_.hearProgress("explore", "a", {{}, {}, "looks round"}, kNow);
  EXPECT_FALSE(state_.view().goals.at("explore").fraction.has_value());
  EXPECT_EQ(state_.view().goals.at("explore").message, "looks round");
}

TEST_F(PanelGoalsTest, AGoalOfSomebodyElseIsShownToo) {
  state_.hearProgress("scan", "theirs", {0.5, {}, ""}, kNow);
  EXPECT_EQ(state_.view().goals.at("scan").fraction, 0.5);
}

TEST_F(PanelGoalsTest, ProgressThatComesAfterTheResultDoesNotBeginAnew) {
  state_.sendGoal("scan", "a", kNow);
  state_.endGoal("scan", "a", "scan: done", false);
  state_.hearProgress("scan", "a", {0.9, {}, ""}, kNow);
  EXPECT_TRUE(state_.view().goals.empty());
}

TEST_F(PanelGoalsTest, TheResultOfAGoalThatWasOvertakenDoesNotEndTheNewOne) {
  state_.sendGoal("scan", "a", kNow);
  state_.sendGoal("scan", "b", kNow);
  state_.endGoal("scan", "a", "scan: canceled", true);
  EXPECT_EQ(state_.view().goals.at("scan").id, "b");
}

TEST_F(PanelGoalsTest, AGoalWithoutAWordIsGivenUp) {
  state_.sendGoal("scan", "a", kNow);
  state_.giveUpGoals(kNow + seconds(4));
  EXPECT_EQ(state_.view().goals.size(), 1U);
  state_.giveUpGoals(kNow + seconds(6));
  EXPECT_TRUE(state_.view().goals.empty());
  EXPECT_EQ(state_.view().note.text, "/robot/place_memory has not answered to ~scan within 5 s");
}

TEST_F(PanelGoalsTest, AGoalThatTheNodeKnowsMayTakeItsTime) {
  state_.sendGoal("scan", "a", kNow);
  state_.hearStatuses("scan", listed("a", GoalStatus::ACTIVE), kNow);
  state_.giveUpGoals(kNow + seconds(600));
  EXPECT_EQ(state_.view().goals.size(), 1U);
}

TEST_F(PanelGoalsTest, AGoalWhoseResultWasSentBeforeTheConnectionStoodEndsByItsStatus) {
  state_.sendGoal("scan", "a", kNow);
  state_.hearStatuses("scan", listed("a", GoalStatus::SUCCEEDED, "176 readings"), kNow);
  state_.giveUpGoals(kNow);
  EXPECT_EQ(state_.view().goals.size(), 1U) << "the result may be on its way";
  state_.giveUpGoals(kNow + seconds(2));
  EXPECT_TRUE(state_.view().goals.empty());
  EXPECT_EQ(state_.view().note.text, "scan: 176 readings");
  EXPECT_FALSE(state_.view().note.is_problem);
}

TEST_F(PanelGoalsTest, AGoalThatIsNoLongerListedIsOver) {
  state_.sendGoal("scan", "a", kNow);
  state_.hearStatuses("scan", listed("a", GoalStatus::ACTIVE), kNow);
  state_.hearStatuses("scan", {}, kNow);
  state_.giveUpGoals(kNow + seconds(2));
  EXPECT_TRUE(state_.view().goals.empty());
  EXPECT_EQ(state_.view().note.text, "~scan is over; its result was not heard");
}

TEST_F(PanelGoalsTest, AStatusFromBeforeTheGoalEndsNothing) {
  state_.hearProgress("scan", "a", {0.1, {}, ""}, kNow);
  state_.hearStatuses("scan", {}, kNow);
  state_.giveUpGoals(kNow + seconds(600));
  EXPECT_EQ(state_.view().goals.size(), 1U);
}

TEST_F(PanelGoalsTest, ANodeThatGoesAwayEndsItsGoalsWithAWord) {
  state_.hearProgress("scan", "a", {0.5, {}, ""}, kNow);
  state_.setPresence(away());
  EXPECT_TRUE(state_.view().goals.empty());
  EXPECT_NE(state_.view().note.text.find("does not run"), std::string::npos);
  EXPECT_TRUE(state_.view().note.is_problem);
}

TEST_F(PanelGoalsTest, ARestartThatNobodySawEndsThemToo) {
  state_.hearProgress("scan", "a", {0.5, {}, ""}, kNow);
  state_.setPresence(there("robot:2"));
  EXPECT_TRUE(state_.view().goals.empty());
  EXPECT_NE(state_.view().note.text.find("was started anew"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::panel
