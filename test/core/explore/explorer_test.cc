#include "core/explore/explorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/explore/floor_plan.h"

namespace place_memory::core {
namespace {

using Aim = Explorer::Aim;
using Outcome = Explorer::Outcome;

// A corridor that goes on into the unknown to the east, and a room that does to the north.
const std::vector<std::string> kOpen{
    "                 ", "####...######### ", "###....######### ", "###....######### ",
    "#............... ", "#............... ", "################ ",
};
const std::vector<std::string> kClosed{
    "################", "####...#########", "###....#########", "###....#########",
    "#..............#", "#..............#", "################",
};

Explorer::Moment at(double x, double y, double way, double doubt = 0.1) {
  return {{x, y, 0.0}, way, doubt};
}

class ExplorerTest : public testing::Test {
 protected:
  ExplorerTest() { options_.closer_looks = 0; }

  static SurveyedCells open() { return floorPlan(kOpen, 5); }
  static SurveyedCells closed() { return floorPlan(kClosed, 5); }

  ExplorerOptions options_;
  const Pose2d home_{1.25, 1.0, 0.0};
};

TEST_F(ExplorerTest, GoesToTheNearestFrontierFirst) {
  Explorer explorer(options_, home_);
  explorer.decide(open(), at(1.25, 1.0, 0.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
  EXPECT_EQ(explorer.frontiers(), 2U);
  EXPECT_GT(explorer.task()->target.y, 2.5);
  EXPECT_FALSE(explorer.task()->way.empty());
  EXPECT_GT(explorer.task()->length, 2.0);
}

TEST_F(ExplorerTest, WhatWasLookedAtIsNoFrontierAnyMore) {
  Explorer explorer(options_, home_);
  explorer.decide(open(), at(1.25, 1.0, 0.0));
  const Pose2d first = explorer.task()->target;
  explorer.arrived(at(first.x, first.y, 3.0));
  explorer.decide(open(), at(first.x, first.y, 3.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
  EXPECT_GT(explorer.task()->target.x, 6.0);
  EXPECT_EQ(explorer.frontiers(), 1U);
}

TEST_F(ExplorerTest, GivesUpWhatIsLeftOnceNoNewGroundIsReachedForLong) {
  for (const double way : {20.0, 21.0}) {
    Explorer explorer(options_, home_);
    explorer.decide(open(), at(1.25, 1.0, 0.0));
    const Pose2d first = explorer.task()->target;
    explorer.arrived(at(first.x, first.y, way));
    explorer.decide(open(), at(first.x, first.y, way));
    ASSERT_TRUE(explorer.task());
    if (way <= options_.patience.least) {
      EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
      continue;
    }
    EXPECT_EQ(explorer.task()->aim, Aim::kHome);
    ASSERT_EQ(explorer.left().size(), 1U);
    EXPECT_EQ(explorer.left()[0].why, "for 21 m other openings had led to no new ground");
    explorer.arrived(at(1.25, 1.0, 26.0));
    explorer.decide(open(), at(1.25, 1.0, 26.0));
    EXPECT_EQ(explorer.outcome(), Outcome::kDone);
  }
}

TEST_F(ExplorerTest, OnTheWayToAFrontierItIsPatient) {
  Explorer explorer(options_, home_);
  explorer.decide(open(), at(1.25, 1.0, 0.0));
  explorer.decide(open(), at(2.0, 1.0, 40.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
}

// As what opens where a mirrored echo lay is gone once the robot hears the wall.
TEST_F(ExplorerTest, FromOneOpeningThatIsGoneToTheNextItLosesItsPatience) {
  std::vector<std::string> without_room = kOpen;
  without_room[0] = "####...##########";
  without_room[1] = "#################";
  for (const double way : {19.0, 21.0}) {
    Explorer explorer(options_, home_);
    explorer.decide(open(), at(1.25, 1.0, 0.0));
    ASSERT_GT(explorer.task()->target.y, 2.5);
    explorer.decide(floorPlan(without_room, 5), at(2.5, 1.0, way));
    ASSERT_EQ(explorer.frontiers(), 1U);
    ASSERT_TRUE(explorer.task());
    EXPECT_EQ(explorer.task()->aim, way < options_.patience.least ? Aim::kFrontier : Aim::kHome);
  }
}

TEST_F(ExplorerTest, WhatLayInSightOfTheWayOpensNothing) {
  SurveyedCells map = open();
  map.trail = {{7.0, 1.0, 0.0}};
  Explorer explorer(options_, home_);
  explorer.decide(map, at(1.25, 1.0, 0.0));
  EXPECT_EQ(explorer.frontiers(), 1U);
  EXPECT_GT(explorer.task()->target.y, 2.5);
}

// A door that the map shows 0.2 m wide, and beyond it ground that nobody saw.
TEST_F(ExplorerTest, WhereNothingElseIsLeftItTriesWhatLooksNarrow) {
  const SurveyedCells map = floorPlan(
      {
          "######################",
          "#.........#.....      ",
          "#.........#.....      ",
          "#.........#.....      ",
          "#...............      ",
          "#.........#.....      ",
          "#.........#.....      ",
          "#.........#.....      ",
          "######################",
      },
      2);
  const Pose2d home{0.8, 0.9, 0.0};
  Explorer explorer(options_, home);
  explorer.decide(map, at(0.8, 0.9, 0.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
  EXPECT_GT(explorer.task()->target.x, 2.4);
  options_.squeeze = 1.0;
  Explorer timid(options_, home);
  timid.decide(map, at(0.8, 0.9, 0.0));
  EXPECT_EQ(timid.outcome(), Outcome::kDone);
}

TEST_F(ExplorerTest, BeforeItIsDoneItLooksWhereItWasNotNear) {
  options_.closer_looks = 1;
  SurveyedCells map = closed();
  for (double x = 1.0; x < 7.5; x += 0.5) map.trail.push_back({x, 1.0, 0.0});
  Explorer explorer(options_, home_);
  explorer.decide(map, at(7.0, 1.0, 6.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
  EXPECT_GT(explorer.task()->target.y, 1.9);  // in the room
  const Pose2d there = explorer.task()->target;
  explorer.arrived(at(there.x, there.y, 11.0));
  map.trail.push_back(there);
  explorer.decide(map, at(there.x, there.y, 11.0));
  EXPECT_EQ(explorer.task()->aim, Aim::kHome);
  EXPECT_TRUE(explorer.left().empty());
}

TEST_F(ExplorerTest, ItLooksNoCloserThanItMayDrive) {
  options_.closer_looks = 1;
  options_.most_distance = 8.0;
  SurveyedCells map = closed();
  for (double x = 1.0; x < 7.5; x += 0.5) map.trail.push_back({x, 1.0, 0.0});
  Explorer explorer(options_, home_);
  explorer.decide(map, at(7.0, 1.0, 6.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kHome);
}

TEST_F(ExplorerTest, GoesHomeWhenNothingIsLeftAndSaysSo) {
  Explorer explorer(options_, home_);
  explorer.decide(closed(), at(6.0, 1.0, 10.0));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kHome);
  EXPECT_FALSE(explorer.isOver());
  explorer.arrived(at(1.25, 1.1, 15.0));
  explorer.decide(closed(), at(1.25, 1.1, 15.0));
  EXPECT_EQ(explorer.outcome(), Outcome::kDone);
  EXPECT_TRUE(explorer.isHome());
  EXPECT_TRUE(explorer.left().empty());
}

TEST_F(ExplorerTest, WhereItIsLetNoNearerToHomeThanItStandsItIsHome) {
  Explorer explorer(options_, home_);
  explorer.decide(closed(), at(6.0, 1.0, 10.0));
  ASSERT_EQ(explorer.task()->aim, Aim::kHome);
  const Explorer::Moment beside = at(1.25, 1.6, 15.0);
  explorer.arrived(beside);
  explorer.decide(closed(), beside);
  EXPECT_EQ(explorer.outcome(), Outcome::kDone);
  EXPECT_TRUE(explorer.isHome());
}

TEST_F(ExplorerTest, StaysWhereItIsIfThatIsAsked) {
  options_.stay = true;
  Explorer explorer(options_, home_);
  explorer.decide(closed(), at(6.0, 1.0, 10.0));
  EXPECT_EQ(explorer.outcome(), Outcome::kDone);
  EXPECT_FALSE(explorer.isHome());
}

TEST_F(ExplorerTest, WhereTheDistanceIsDrivenItGoesHomeAndTellsWhatIsLeft) {
  options_.most_distance = 8.0;
  Explorer explorer(options_, home_);
  explorer.decide(open(), at(6.0, 1.0, 8.5));
  EXPECT_EQ(explorer.task()->aim, Aim::kHome);
  explorer.decide(open(), at(1.25, 1.0, 13.0));
  EXPECT_EQ(explorer.outcome(), Outcome::kBoundReached);
  ASSERT_FALSE(explorer.left().empty());
  EXPECT_NE(explorer.left().front().why.find("distance"), std::string::npos);
}

TEST_F(ExplorerTest, ABarredWayIsTriedOnceMoreAndThenLeftWithItsReason) {
  Explorer explorer(options_, home_);
  Explorer::Moment now = at(1.25, 1.0, 0.0);
  int blocked = 0;
  for (int i = 0; i < 100 && !explorer.isOver(); ++i, now.way += 0.5) {
    explorer.decide(open(), now);
    if (!explorer.task()) continue;
    if (explorer.task()->aim == Aim::kHome) {
      now.robot = home_;
    } else {
      // Everything that leads away from home is barred half a metre from there.
      ++blocked;
      explorer.blocked(now, explorer.task()->way.front(), "something stands in the way");
    }
  }
  EXPECT_TRUE(explorer.isOver());
  EXPECT_EQ(explorer.outcome(), Outcome::kDone);
  EXPECT_GT(blocked, 1);
  ASSERT_FALSE(explorer.left().empty());
  for (const Explorer::Left& left : explorer.left()) {
    EXPECT_EQ(left.why, "something stands in the way") << left.spot.x << ' ' << left.spot.y;
  }
}

TEST_F(ExplorerTest, InDoubtItClosesALoopFirst) {
  options_.patience.least = 100.0;
  Explorer explorer(options_, home_);
  // It was sure at home, has driven long since, and is not far from there again.
  explorer.decide(open(), at(1.25, 1.0, 0.0));
  explorer.decide(open(), at(3.0, 1.0, 40.0, 2.0 * options_.doubt));
  ASSERT_TRUE(explorer.task());
  EXPECT_EQ(explorer.task()->aim, Aim::kLoop);
  EXPECT_NEAR(explorer.task()->target.x, 1.25, 0.4);
  EXPECT_EQ(explorer.loopsSought(), 1U);
  // If that does not help it goes on, and does not come back at once.
  explorer.arrived(at(1.25, 1.0, 42.0, 2.0 * options_.doubt));
  explorer.decide(open(), at(1.25, 1.0, 42.0, 2.0 * options_.doubt));
  EXPECT_EQ(explorer.task()->aim, Aim::kFrontier);
}

TEST_F(ExplorerTest, DecidesTheSameFromTheSame) {
  Explorer one(options_, home_), other(options_, home_);
  one.decide(open(), at(1.25, 1.0, 0.0));
  other.decide(open(), at(1.25, 1.0, 0.0));
  EXPECT_EQ(one.task()->target, other.task()->target);
  EXPECT_EQ(one.task()->way, other.task()->way);
}

}  // namespace
}  // namespace place_memory::core
