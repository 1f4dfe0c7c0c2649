// What a drive takes from others than its own sensors.
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "core/mapping/mapper.h"
#include "core/random_room.h"

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;

const RandomRoom kRoom(3);

void expectNear(const Pose2d& pose, const Pose2d& wanted, double delta) {
  EXPECT_NEAR(pose.x, wanted.x, delta);
  EXPECT_NEAR(pose.y, wanted.y, delta);
  EXPECT_NEAR(wrapAngle(pose.yaw - wanted.yaw), 0.0, delta);
}

/// A robot that scans where it stands.
void scanAt(Mapper& mapper, int stamp, const Pose2d& odom_from_base, const Pose2d& room_from_base) {
  mapper.addStanding(nanoseconds(stamp), odom_from_base, kRoom.scanFrom(room_from_base).readings);
}

TEST(MapperGuests, AStandingScanIsNoPlaceUntilAPersonSaysSo) {
  Mapper mapper{MapperOptions()};
  scanAt(mapper, 100, {1.0, 2.0, 0.5}, {});
  ASSERT_EQ(mapper.takeDecisions().size(), 1U);
  EXPECT_TRUE(mapper.places().empty());
  mapper.adopt(7, nanoseconds(100));
  ASSERT_EQ(mapper.places().size(), 1U);
  EXPECT_EQ(mapper.places()[0].id, 7);
  EXPECT_EQ(mapper.map().next_place, 8);
  EXPECT_EQ(mapper.map().named, std::vector<PlaceId>{7});
  mapper.adopt(8, nanoseconds(200));  // there is no such scan
  EXPECT_EQ(mapper.places().size(), 1U);
}

TEST(MapperGuests, OfTwoPlacesAtOneSpotTheOneThatAPersonNamedStays) {
  Mapper mapper{MapperOptions()};
  scanAt(mapper, 100, {}, {});
  mapper.adopt(1, nanoseconds(100));
  scanAt(mapper, 200, {0.1, 0.0, 0.0}, {0.1, 0.0, 0.0});
  mapper.adopt(2, nanoseconds(200));
  EXPECT_EQ(mapper.places().size(), 2U);  // both were named

  KeptMap kept = mapper.map();
  kept.named = {};
  Mapper later{MapperOptions()};
  later.restore(kept);
  scanAt(later, 300, {}, {0.05, 0.0, 0.0});
  later.adopt(3, nanoseconds(300));
  // It lies in a session apart: whether it doubles the others is not known.
  EXPECT_EQ(later.places().size(), 3U);
}

TEST(MapperGuests, APlaceThatIsForgottenLeavesItsScan) {
  Mapper mapper{MapperOptions()};
  scanAt(mapper, 100, {}, {});
  mapper.adopt(1, nanoseconds(100));
  mapper.forget(1);
  mapper.forget(1);
  EXPECT_TRUE(mapper.places().empty());
  EXPECT_TRUE(mapper.map().named.empty());
  EXPECT_EQ(mapper.graph().nodes().size(), 1U);
  EXPECT_EQ(mapper.map().next_place, 2);
}

TEST(MapperGuests, WhereAPersonSaysTheRobotIsItIsAtOnce) {
  Mapper mapper{MapperOptions()};
  scanAt(mapper, 100, {}, {});
  mapper.adopt(1, nanoseconds(100));
  const KeptMap kept = mapper.map();

  MapperOptions options;
  options.mode = MapperMode::kLocalize;
  Mapper later(options);
  later.restore(kept);
  later.addOdometry(nanoseconds(1000), {5.0, 5.0, 1.0});
  EXPECT_FALSE(later.mapFromOdom());
  EXPECT_EQ(later.lost(), 1.0);
  later.setPose({0.4, -0.2, 0.3});
  ASSERT_TRUE(later.mapFromOdom());
  expectNear(*later.mapFromOdom() * Pose2d{5.0, 5.0, 1.0}, {0.4, -0.2, 0.3}, 1e-9);
  EXPECT_LT(later.lost(), 0.5);
  ASSERT_FALSE(later.belief().places.empty());
  EXPECT_EQ(later.belief().places[0].first, 1);

  // It drives on, and a scan there agrees.
  const Pose2d motion{0.3, 0.1, 0.2};
  const Pose2d odom = Pose2d{5.0, 5.0, 1.0} * motion;
  scanAt(later, 2000, odom, Pose2d{0.4, -0.2, 0.3} * motion);
  ASSERT_TRUE(later.mapFromOdom());
  expectNear(*later.mapFromOdom() * odom, Pose2d{0.4, -0.2, 0.3} * motion, 0.15);
  const std::vector<ScanDecision> decisions = later.takeDecisions();
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions[0].kind, ScanDecision::Kind::kTracked);
  EXPECT_EQ(decisions[0].place, 1);
}

/// A robot that starts anew, near a place that is known, of which two scans say so.
class MapperQuestions : public testing::Test {
 protected:
  MapperQuestions() {
    Mapper before{MapperOptions()};
    scanAt(before, 100, {}, {});
    before.adopt(1, nanoseconds(100));
    mapper_.restore(before.map());
    mapper_.takeDecisions();
    scanOn(0.1);
    EXPECT_TRUE(mapper_.closureQuestions().empty());
    scanOn(0.2);
  }

  void scanOn(double x) {
    scanAt(mapper_, stamp_ += 100, {5.0 + x, 5.0, 0.0}, {x, 0.0, 0.0});
    odom_ = {5.0 + x, 5.0, 0.0};
    room_ = {x, 0.0, 0.0};
  }

  Mapper mapper_{MapperOptions()};
  int stamp_ = 1000;
  Pose2d odom_, room_;
};

TEST_F(MapperQuestions, APersonIsAskedOnceTwoScansAgree) {
  const std::vector<ClosureQuestion> questions = mapper_.closureQuestions();
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_EQ(questions[0].place, 1);
  EXPECT_EQ(questions[0].scans, 2U);
  EXPECT_NE(questions[0].evidence.find("2 scans"), std::string::npos);
  EXPECT_FALSE(mapper_.mapFromOdom());
  EXPECT_EQ(mapper_.confirmClosure(2), ClosureWord::kNoQuestion);
  EXPECT_EQ(mapper_.cutClosure(2), ClosureWord::kNoQuestion);
}

TEST_F(MapperQuestions, WhatAPersonConfirmsJoinsTheMap) {
  EXPECT_EQ(mapper_.confirmClosure(1), ClosureWord::kDone);
  ASSERT_TRUE(mapper_.mapFromOdom());
  expectNear(*mapper_.mapFromOdom() * odom_, room_, 0.15);
  const std::vector<MapperEvent> events = mapper_.takeEvents();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, MapperEvent::Kind::kJoined);
  EXPECT_EQ(events[0].witnesses, std::vector<PlaceId>{1});
  EXPECT_TRUE(mapper_.closureQuestions().empty());
  EXPECT_EQ(mapper_.confirmClosure(1), ClosureWord::kNoQuestion);

  // And is taken back where a person says that it was wrong.
  EXPECT_EQ(mapper_.cutClosure(1), ClosureWord::kDone);
  EXPECT_FALSE(mapper_.mapFromOdom());
  EXPECT_EQ(mapper_.takeEvents().size(), 1U);
}

TEST_F(MapperQuestions, NothingComesOfWhatAPersonCuts) {
  EXPECT_EQ(mapper_.cutClosure(1), ClosureWord::kDone);
  EXPECT_TRUE(mapper_.closureQuestions().empty());
  for (int i = 3; i < 30; ++i) scanOn(0.02 * i);
  EXPECT_TRUE(mapper_.closureQuestions().empty());
  EXPECT_FALSE(mapper_.mapFromOdom());
  EXPECT_TRUE(mapper_.takeEvents().empty());
}

}  // namespace
}  // namespace place_memory::core
