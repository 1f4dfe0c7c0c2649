#include <gtest/gtest.h>

#include <algorithm>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

// Places that are learned after a restart, when odometry begins anew.
namespace place_memory::core {
namespace {

/// Two places, at 0 and at 7.5 m, in a store; then the memory is opened again, with the robot at
/// the second one and odometry at its origin, turned by a quarter.
class SessionTest : public testing::Test {
 protected:
  static Scan scanAt(unsigned seed, const Pose2d& odom_from_scan) {
    Scan scan = makeRandomScan(seed);
    scan.odom_from_scan = odom_from_scan;
    scan.robot_in_scan = {0.1, 0.2, 0.3};
    return scan;
  }

  PlaceMemoryOptions options() const {
    PlaceMemoryOptions options;
    options.store_path = folder_.file("places.db");
    options.recognizer.calibration.right = {-20.0, 0.0, 0.0, 0.0, 30.0};
    options.recognizer.calibration.known = {-20.0};
    return options;
  }

  static void expectNear(const Pose2d& expected, const Pose2d& pose) {
    EXPECT_NEAR(expected.x, pose.x, 0.02);
    EXPECT_NEAR(expected.y, pose.y, 0.02);
    EXPECT_NEAR(wrapAngle(expected.yaw - pose.yaw), 0.0, 0.02);
  }

  SessionTest() {
    {
      PlaceMemory memory(options());
      memory.learn(scanAt(1, {0.0, 0.0, 0.0}), "origin");
      memory.learn(scanAt(2, {7.5, 0.0, kPi / 2.0}), "start");
    }
    memory_ = std::make_unique<PlaceMemory>(options());
  }

  const TemporaryFolder folder_;
  std::unique_ptr<PlaceMemory> memory_;
};

TEST_F(SessionTest, WhatIsLearnedAfterARecognitionLiesWhereItBelongs) {
  const PlaceMemory::Answer answer = memory_->recognize(scanAt(2, {}), kHeadingWindow);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  expectNear({7.5, 0.0, kPi / 2.0}, *answer.whereabouts.map_from_odom);
  const PlaceMemory::Learned learned = memory_->learn(scanAt(3, {3.42, 0.0, 0.0}), "next");
  EXPECT_FALSE(learned.apart);
  EXPECT_EQ(learned.message, "");
  EXPECT_EQ(learned.place.session, kFirstSession);
  expectNear({7.5, 3.42, kPi / 2.0}, learned.place.map_from_place);
  EXPECT_EQ(learned.place.place_from_robot, (Pose2d{0.1, 0.2, 0.3}));
}

TEST_F(SessionTest, WhatIsLearnedBeforeLiesApartAndTheAnswerSaysSo) {
  EXPECT_FALSE(memory_->whereabouts().map_from_odom);
  const PlaceMemory::Learned learned = memory_->learn(scanAt(3, {3.42, 0.0, 0.0}), "next");
  EXPECT_TRUE(learned.apart);
  EXPECT_NE(learned.message, "");
  EXPECT_EQ(learned.place.session, 2);
  expectNear({3.42, 0.0, 0.0}, learned.place.map_from_place);
  const PlaceMemory::Learned second = memory_->learn(scanAt(4, {5.0, 0.0, 0.0}), "after");
  EXPECT_TRUE(second.apart);
  EXPECT_EQ(second.place.session, 2);
}

TEST_F(SessionTest, ARecognitionMovesASessionToWhereItBelongs) {
  memory_->learn(scanAt(3, {3.42, 0.0, 0.0}), "next");
  memory_->learn(scanAt(4, {5.0, 1.0, 0.0}), "after");
  std::vector<MapChange> changes;
  memory_->listen([&changes](const MapChange& change) { changes.push_back(change); });
  const PlaceMemory::Answer answer = memory_->recognize(scanAt(2, {}), kHeadingWindow);
  EXPECT_EQ(answer.joined, 2U);
  EXPECT_FALSE(answer.whereabouts.apart);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].edits.size(), 2U);
  const std::vector<Place> places = memory_->map().places;
  ASSERT_EQ(places.size(), 4U);
  for (const Place& place : places) EXPECT_EQ(place.session, kFirstSession);
  expectNear({7.5, 3.42, kPi / 2.0}, places[2].map_from_place);
  expectNear({6.5, 5.0, kPi / 2.0}, places[3].map_from_place);
  EXPECT_EQ(memory_->recognize(scanAt(2, {}), kHeadingWindow).joined, 0U);
  memory_.reset();
  EXPECT_TRUE(PlaceMemory(options()).map().places == places);
}

// Of a run in which nothing was recognized.
TEST_F(SessionTest, AnOlderSessionApartIsJoinedInALaterRun) {
  memory_->learn(scanAt(3, {3.42, 0.0, 0.0}), "next");
  memory_ = nullptr;
  memory_ = std::make_unique<PlaceMemory>(options());
  memory_->recognize(scanAt(2, {}), kHeadingWindow);
  const PlaceMemory::Answer answer = memory_->recognize(scanAt(3, {2.0, 0.0, 0.0}), kHeadingWindow);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  EXPECT_EQ(answer.joined, 1U);
  // The answer, too, is in the frame that the place moved to.
  expectNear(Pose2d{7.5, 2.0, kPi / 2.0} * Pose2d{0.1, 0.2, 0.3},
             answer.recognition.map_from_robot);
  expectNear({7.5, 2.0, kPi / 2.0}, memory_->place(3)->map_from_place);
  EXPECT_EQ(memory_->place(3)->session, kFirstSession);
}

TEST_F(SessionTest, AfterAJumpASessionBeginsAgain) {
  memory_->recognize(scanAt(2, {}), kHeadingWindow);
  memory_->forgetWhereabouts();
  EXPECT_FALSE(memory_->whereabouts().map_from_odom);
  EXPECT_EQ(memory_->whereabouts().current_label, "");
  const PlaceMemory::Learned learned = memory_->learn(scanAt(3, {1.0, 0.0, 0.0}), "next");
  EXPECT_TRUE(learned.apart);
  EXPECT_TRUE(memory_->map().links.size() == 1U);
}

TEST_F(SessionTest, WithoutOdometryAllPlacesAreOfOneSession) {
  memory_.reset();
  PlaceMemoryOptions blind = options();
  blind.recognizer.located = false;
  PlaceMemory memory(blind);
  memory.recognize(scanAt(2, {}), kHeadingWindow);
  const PlaceMemory::Learned learned = memory.learn(scanAt(3, {}), "next");
  EXPECT_FALSE(learned.apart);
  EXPECT_EQ(learned.place.session, kFirstSession);
  EXPECT_EQ(learned.place.map_from_place, Pose2d{});
  EXPECT_EQ(memory.map().links.back().covariance[0], kUnknownVariance);
}

TEST_F(SessionTest, ALinkHasTheWayFromWhereTheRobotStood) {
  const PlaceMemory::Answer answer = memory_->recognize(scanAt(2, {2.0, 0.0, 0.0}), kHeadingWindow);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  const Place learned = memory_->learn(scanAt(3, {5.0, 4.0, 0.5}), "next").place;
  const std::vector<PlaceLink> links = memory_->map().links;
  ASSERT_EQ(links.size(), 2U);
  const PlaceLink& driven = links[0];
  expectNear({7.5, 0.0, kPi / 2.0}, driven.first_from_second);
  EXPECT_NEAR(driven.covariance[0], 0.05 * 0.05 + 0.75 * 0.75, 1e-9);
  EXPECT_NEAR(driven.covariance[4], driven.covariance[0], 1e-9);
  EXPECT_NEAR(driven.covariance[8], 0.01, 1e-9);
  EXPECT_EQ(driven.covariance[1], 0.0);
  EXPECT_TRUE((driven.forward == LinkDirection{1, 0, std::chrono::seconds(1002), 1.0, 0.0, 1.0}));
  EXPECT_TRUE(driven.backward == LinkDirection{});
  const PlaceLink& after_recognition = links[1];
  EXPECT_EQ(after_recognition.second, learned.id);
  expectNear({3.0, 4.0, 0.5}, after_recognition.first_from_second);
  EXPECT_GT(after_recognition.covariance[0], 0.05 * 0.05 + 0.5 * 0.5);
}

TEST_F(SessionTest, EachWayAlongALinkIsCounted) {
  memory_->recognize(scanAt(1, {}), kHeadingWindow);
  memory_->recognize(scanAt(2, {7.5, 0.0, 0.0}), kHeadingWindow);
  memory_->recognize(scanAt(2, {7.5, 0.0, 0.0}), kHeadingWindow);  // it did not go anywhere
  memory_->recognize(scanAt(1, {}), kHeadingWindow);
  memory_->recognize(scanAt(2, {7.5, 0.0, 0.0}), kHeadingWindow);
  const PlaceLink link = memory_->map().links.front();
  EXPECT_EQ(link.forward.succeeded, 3U);
  EXPECT_EQ(link.backward.succeeded, 1U);
  EXPECT_EQ(link.forward.failed, 0U);
  memory_.reset();
  EXPECT_TRUE(PlaceMemory(options()).map().links.front() == link);
}

}  // namespace
}  // namespace place_memory::core
