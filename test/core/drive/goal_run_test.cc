#include "core/drive/goal_run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace place_memory::core {
namespace {

using Outcome = GoalRun::Outcome;
using std::chrono::seconds;

/// Three places along x, three metres apart, and a fourth beside the second one. The plans are
/// those that each test says.
class GoalRunTest : public testing::Test {
 protected:
  static Place placeAt(PlaceId id, double x, double y) {
    Place place;
    place.id = id;
    place.label = std::string(1, "?abcd"[id]);
    place.map_from_place = {x, y, 0.0};
    return place;
  }

  static RoutePlan planOver(const std::vector<PlaceId>& ids) {
    const Place places[] = {
        {}, placeAt(1, 0, 0), placeAt(2, 3, 0), placeAt(3, 6, 0), placeAt(4, 3, 3)};
    RoutePlan plan;
    for (const PlaceId id : ids) plan.best.push_back(places[id]);
    plan.answer.status = ids.empty() ? RouteAnswer::Status::kNoRoute : RouteAnswer::Status::kFound;
    plan.answer.reason = ids.empty() ? "no way is left" : "";
    plan.answer.best.cost = 30.0;
    return plan;
  }

  GoalRun run(std::optional<Pose2d> goal = std::nullopt) {
    GoalRun::Hooks hooks;
    hooks.plan = [this](const GoalRun::Wish& wish) {
      asked_.push_back(wish);
      const RoutePlan plan = plans_.front();
      plans_.erase(plans_.begin());
      return plan;
    };
    hooks.report = [this](const Traversal& traversal) { reports_.push_back(traversal); };
    return {hooks, goal, "test"};
  }

  std::vector<RoutePlan> plans_{planOver({1, 2, 3})};
  std::vector<GoalRun::Wish> asked_;
  std::vector<Traversal> reports_;
};

TEST_F(GoalRunTest, DrivesLegByLegAndLinksLearn) {
  GoalRun run = this->run();
  run.begin({0.1, 0.1, 0.0}, seconds(10));
  ASSERT_TRUE(run.leg());
  EXPECT_EQ(run.leg()->label, "b");
  EXPECT_EQ(run.leg()->target, (Pose2d{3.0, 0.0, 0.0}));
  EXPECT_EQ(run.legsLeft(), 2U);
  EXPECT_NEAR(run.timeLeft(3.0), 30.0, 1e-9);
  run.arrived(seconds(20));
  EXPECT_EQ(run.leg()->label, "c");
  EXPECT_NEAR(run.timeLeft(1.5), 7.5, 1e-9);
  run.arrived(seconds(35));
  EXPECT_TRUE(run.isOver());
  EXPECT_EQ(run.outcome(), Outcome::kReached);
  EXPECT_EQ(run.legsDone(), 2U);
  ASSERT_EQ(reports_.size(), 2U);
  EXPECT_EQ(reports_[1], (Traversal{2, 3, seconds(20), seconds(35), true, "test"}));
}

TEST_F(GoalRunTest, FarFromTheFirstPlaceItGoesThereFirst) {
  GoalRun run = this->run();
  run.begin({0.0, 2.0, 0.0}, seconds(10));
  EXPECT_EQ(run.leg()->label, "a");
  EXPECT_EQ(run.leg()->from, kNoPlace);
  EXPECT_EQ(run.legsLeft(), 3U);
  run.arrived(seconds(12));
  EXPECT_EQ(run.leg()->label, "b");
  EXPECT_TRUE(reports_.empty());
}

TEST_F(GoalRunTest, ABlockedLinkLearnsAndIsNotTriedAgain) {
  plans_.push_back(planOver({2, 4, 3}));
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.arrived(seconds(20));
  run.blocked("something stands in the way", seconds(30));
  ASSERT_EQ(reports_.size(), 2U);
  EXPECT_EQ(reports_[1], (Traversal{2, 3, seconds(20), seconds(30), false, "test"}));
  ASSERT_TRUE(run.leg());
  EXPECT_TRUE(run.leg()->back);
  EXPECT_EQ(run.leg()->target, (Pose2d{3.0, 0.0, 0.0}));
  run.arrived(seconds(33));
  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_EQ(asked_[1].from, 2);
  EXPECT_EQ(asked_[1].avoided, (GoalRun::Avoided{{2, 3}}));
  EXPECT_EQ(run.leg()->label, "d");
  run.arrived(seconds(40));
  run.arrived(seconds(50));
  EXPECT_EQ(run.outcome(), Outcome::kReached);
  EXPECT_NE(run.failedLeg().find("\"b\" to \"c\": something stands"), std::string::npos);
  EXPECT_EQ(run.tried().size(), 1U);
}

TEST_F(GoalRunTest, WhereNoWayIsLeftItSaysSo) {
  plans_.push_back(planOver({}));
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.blocked("closed", seconds(20));
  run.arrived(seconds(25));
  EXPECT_EQ(run.outcome(), Outcome::kNoRoute);
  EXPECT_EQ(run.message(), "no way is left");
  EXPECT_FALSE(run.leg());
}

TEST_F(GoalRunTest, BlockedBothWaysItBeginsAtAnotherPlace) {
  plans_.push_back(planOver({4, 3}));
  plans_.push_back(planOver({2, 3}));
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.blocked("closed", seconds(20));
  EXPECT_TRUE(run.leg()->back);
  run.blocked("closed as well", seconds(30));
  ASSERT_TRUE(run.leg());
  EXPECT_EQ(run.leg()->label, "d");
  EXPECT_EQ(run.leg()->from, kNoPlace);
  EXPECT_EQ(asked_[1].from, kNoPlace);
  EXPECT_EQ(asked_[1].avoided, (GoalRun::Avoided{{1, 2}}));
  EXPECT_EQ(asked_[1].unreachable, (std::vector<PlaceId>{1}));
  run.blocked("and there", seconds(40));
  EXPECT_EQ(asked_[2].unreachable, (std::vector<PlaceId>{1, 4}));
  EXPECT_EQ(run.leg()->label, "b");
  run.arrived(seconds(50));
  run.arrived(seconds(60));
  EXPECT_EQ(run.outcome(), Outcome::kReached);
  EXPECT_EQ(run.tried().size(), 3U);
  EXPECT_EQ(reports_.size(), 2U);  // of links alone
}

TEST_F(GoalRunTest, WhereItGotToIsReachableAgain) {
  plans_ = {planOver({1, 2}), planOver({4, 2}), planOver({4})};
  GoalRun run = this->run();
  run.begin({1.5, 0.0, 0.0}, seconds(10));
  run.blocked("closed", seconds(20));
  run.arrived(seconds(30));
  run.blocked("closed", seconds(40));
  run.arrived(seconds(50));
  ASSERT_EQ(asked_.size(), 3U);
  EXPECT_EQ(asked_[1].unreachable, (std::vector<PlaceId>{1}));
  EXPECT_TRUE(asked_[2].unreachable.empty());
}

// That no way leads from there does not say that none leads to the goal.
TEST_F(GoalRunTest, WhereNoOtherPlaceIsAtHandItIsBlocked) {
  plans_.push_back(planOver({}));
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.blocked("closed", seconds(20));
  run.blocked("closed as well", seconds(30));
  EXPECT_EQ(run.outcome(), Outcome::kBlocked);
  EXPECT_NE(run.message().find("back to \"a\": closed as well"), std::string::npos);
  EXPECT_EQ(run.tried().size(), 2U);
  EXPECT_EQ(reports_.size(), 1U);
}

TEST_F(GoalRunTest, ThreeOtherPlacesAreTriedAndNoMore) {
  plans_ = {planOver({1, 3}), planOver({2, 3}), planOver({4, 3}), planOver({3})};
  GoalRun run = this->run();
  run.begin({1.5, 0.0, 0.0}, seconds(10));
  for (int i = 0; i < 3; ++i) {
    run.blocked("closed", seconds(20 + i));
    EXPECT_FALSE(run.isOver());
  }
  run.blocked("closed", seconds(30));
  EXPECT_EQ(run.outcome(), Outcome::kBlocked);
  EXPECT_EQ(asked_.size(), 4U);
}

TEST_F(GoalRunTest, AGoalThatIsAPoseIsDrivenToBeyondTheLastPlace) {
  plans_ = {planOver({2})};
  GoalRun run = this->run(Pose2d{3.5, 0.5, 1.0});
  run.begin({3.0, 0.2, 0.0}, seconds(10));
  EXPECT_EQ(run.leg()->target, (Pose2d{3.5, 0.5, 1.0}));
  EXPECT_EQ(run.legsLeft(), 1U);
  run.arrived(seconds(12));
  EXPECT_EQ(run.outcome(), Outcome::kReached);
  EXPECT_TRUE(reports_.empty());
}

TEST_F(GoalRunTest, WhereTheRobotIsAlreadyItIsThere) {
  plans_ = {planOver({2})};
  GoalRun run = this->run();
  run.begin({3.0, 0.2, 0.0}, seconds(10));
  EXPECT_EQ(run.outcome(), Outcome::kReached);
}

TEST_F(GoalRunTest, WhereTheGoalIsTheNearestPlaceItGoesThereAllTheSame) {
  plans_ = {planOver({2})};
  GoalRun run = this->run();
  run.begin({3.0, 2.0, 0.0}, seconds(10));
  ASSERT_FALSE(run.isOver());
  EXPECT_EQ(run.leg()->target, (Pose2d{3.0, 0.0, 0.0}));
  run.arrived(seconds(15));
  EXPECT_EQ(run.outcome(), Outcome::kReached);
}

TEST_F(GoalRunTest, FollowsTheMapUnderTheRobot) {
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  std::vector<Place> map = planOver({1, 2, 3}).best;
  const auto find = [&](PlaceId id) {
    const auto found =
        std::find_if(map.begin(), map.end(), [id](const Place& place) { return place.id == id; });
    return found == map.end() ? std::nullopt : std::optional<Place>(*found);
  };
  map[1].label = "desk";
  map[1].map_from_place.x = 3.4;
  run.follow(find, seconds(11));
  EXPECT_EQ(run.leg()->label, "desk");
  EXPECT_EQ(run.leg()->target, (Pose2d{3.4, 0.0, 0.0}));
  EXPECT_NE(run.legInWords().find("desk"), std::string::npos);
  EXPECT_EQ(asked_.size(), 1U);
  map.pop_back();
  run.follow(find, seconds(12));
  EXPECT_EQ(run.outcome(), Outcome::kNotThere);
  EXPECT_EQ(run.legInWords(), "");
}

TEST_F(GoalRunTest, PlacesThatAreRemovedOnTheWay) {
  plans_.push_back(planOver({1, 4, 3}));
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.placeRemoved(4, seconds(11));
  EXPECT_EQ(asked_.size(), 1U);  // not on the way
  run.placeRemoved(2, seconds(12));
  EXPECT_EQ(run.leg()->label, "a");  // from wherever it is between the two
  run.arrived(seconds(13));
  EXPECT_EQ(run.leg()->label, "d");
  run.placeRemoved(3, seconds(14));
  EXPECT_EQ(run.outcome(), Outcome::kNotThere);
}

TEST_F(GoalRunTest, EndsWithAWordAndStaysSo) {
  GoalRun run = this->run();
  run.begin({}, seconds(10));
  run.end(Outcome::kCanceled, "it was canceled");
  run.arrived(seconds(20));
  run.blocked("late", seconds(20));
  run.end(Outcome::kLost, "later");
  EXPECT_EQ(run.outcome(), Outcome::kCanceled);
  EXPECT_EQ(run.message(), "it was canceled");
  EXPECT_FALSE(run.leg());
  EXPECT_TRUE(reports_.empty());
}

}  // namespace
}  // namespace place_memory::core
