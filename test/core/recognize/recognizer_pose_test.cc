#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/recognize/recognizer.h"
#include "core/recognize/rooms.h"

namespace place_memory::core {
namespace {

TEST(RecognizerPose, AsksOnceForTheFramesOfThePlacesThatRankFirst) {
  const PlaceIndex places = rooms(15);
  std::vector<std::vector<PlaceId>> asked;
  const auto frames = [&asked](const std::vector<PlaceId>& ids) {
    asked.push_back(ids);
    return framesOf(ids);
  };
  const Recognizer recognizer(usualOptions());
  const auto recognition = recognizer.recognize(scanIn(3, {}), places, frames, kWindow);
  ASSERT_TRUE(recognition);
  ASSERT_EQ(asked.size(), 1U);
  ASSERT_EQ(asked.front().size(), 10U);
  for (std::size_t i = 0; i < asked.front().size(); ++i) {
    EXPECT_EQ(std::count(asked.front().begin(), asked.front().end(), recognition->matches[i].id),
              1);
  }
}

TEST(RecognizerPose, HasNoAnswerWhereAPlaceIsGone) {
  const auto gone = [](const std::vector<PlaceId>&) {
    return std::optional<std::vector<PlaceFrame>>();
  };
  EXPECT_FALSE(Recognizer(usualOptions()).recognize(scanIn(1, {}), rooms(3), gone, kWindow));
}

TEST(RecognizerPose, ThePoseLiesInTheFrameOfTheMatchedPlacesSession) {
  PlaceIndex twins = rooms(1);
  twins.put(2, RandomRoom(1).scanFrom({}).grid);
  const auto frames = [](const std::vector<PlaceId>& ids) {
    std::vector<PlaceFrame> of;
    for (const PlaceId id : ids) of.push_back({placePose(id), id});
    return std::optional(of);
  };
  RecognizerOptions options = usualOptions();
  options.calibration.right[13] = 0.01;  // for each point of a score that nothing contradicts
  const Recognizer recognizer(options);
  const Recognition apart = recognizer.recognize(scanIn(1, {}), twins, frames, kWindow).value();
  EXPECT_EQ(apart.matches.front().id, 1);
  expectSamePose(apart.map_from_robot, placePose(1) * apart.matches.front().place_from_scan);
  // Within one session the twin puts the robot elsewhere, and the scan could be of either.
  const Recognition together = ask(recognizer, scanIn(1, {}), twins, kWindow);
  EXPECT_LT(together.matches.front().probability, apart.matches.front().probability);
}

TEST(RecognizerPose, ARobotThatMovedDuringItsScanIsLessSureOfWhereItStands) {
  const PlaceIndex places = rooms(3);
  const Recognizer recognizer(usualOptions());
  Scan scan = scanIn(2, {});
  const Recognition stood = ask(recognizer, scan, places, kWindow);
  scan.robot_in_scan = {4.0, 0.0, 0.0};
  const Recognition moved = ask(recognizer, scan, places, kWindow);
  const auto area = [](const Recognition& found) {
    return found.covariance[0] + found.covariance[4];
  };
  // Four metres off, the variance of the heading comes on top sixteenfold, but for what it has to
  // do with the position.
  EXPECT_GT(area(moved), area(stood) + 8.0 * stood.covariance[8]);
  EXPECT_EQ(moved.covariance[8], stood.covariance[8]);
}

TEST(RecognizerPose, ThePosePutsTheRobotWhereItStands) {
  const PlaceIndex places = rooms(6);
  const Recognizer recognizer(usualOptions());
  std::mt19937 engine(18);
  for (PlaceId id = 1; id <= 6; ++id) {
    const Pose2d truth = randomPose(engine, 0.6, 0.25);
    Scan scan = scanIn(id, truth);
    scan.robot_in_scan = randomPose(engine, 0.3, 3.0);
    const Recognition recognition = ask(recognizer, scan, places, kWindow);
    ASSERT_FALSE(recognition.matches.empty());
    ASSERT_EQ(recognition.matches.front().id, id);
    expectSamePose(
        recognition.map_from_robot,
        placePose(id) * recognition.matches.front().place_from_scan * scan.robot_in_scan);
    const Pose2d stands = placePose(id) * truth * scan.robot_in_scan;
    EXPECT_LT(std::hypot(recognition.map_from_robot.x - stands.x,
                         recognition.map_from_robot.y - stands.y),
              2.0 * kDefaultCellSize);
    EXPECT_NEAR(wrapAngle(recognition.map_from_robot.yaw - stands.yaw), 0.0, 1.5 * kStep);
  }
}

TEST(RecognizerPose, TheCovarianceIsSymmetricWithVariancesAboveZero) {
  const Recognition recognition = ask(Recognizer(usualOptions()), scanIn(2, {}), rooms(3), kWindow);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_GT(recognition.covariance[4 * r], 0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(recognition.covariance[3 * r + c], recognition.covariance[3 * c + r], 1e-12);
    }
  }
}

}  // namespace
}  // namespace place_memory::core
