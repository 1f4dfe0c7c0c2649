#include "core/recognize/recognizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/random_room.h"

namespace place_memory::core {
namespace {

constexpr double kWindow = 0.35;  ///< of headings [rad]
constexpr double kStep = 3.0 * kPi / 180.0;
constexpr SearchMethod kMethods[] = {SearchMethod::kNearestNeighbour, SearchMethod::kHillClimbing,
                                     SearchMethod::kRestarts, SearchMethod::kExhaustive};

RecognizerOptions usualOptions() {
  RecognizerOptions options;
  options.metric.weights = {{{1.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {-2.0, -1.0, 3.0}}};
  return options;
}

RecognizerOptions optionsWith(SearchMethod method) {
  RecognizerOptions options = usualOptions();
  options.method = method;
  return options;
}

Pose2d placePose(PlaceId id) {
  const auto n = static_cast<double>(id);
  return {3.0 * n, -2.0 * n, 0.4 * n};
}

/// Places 1 to `count`, each a room of its own, sensed from its middle.
PlaceIndex rooms(int count, double scale = 1.0, double cell_size = kDefaultCellSize) {
  PlaceIndex index;
  for (int id = 1; id <= count; ++id) {
    const RandomRoom room(static_cast<unsigned>(id), scale);
    index.put(id, room.scanFrom({}, cell_size).grid);
  }
  return index;
}

Scan scanIn(PlaceId id, const Pose2d& place_from_scan) {
  return RandomRoom(static_cast<unsigned>(id)).scanFrom(place_from_scan);
}

Pose2d randomPose(std::mt19937& engine, double metres, double radians) {
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  return {metres * share(engine), metres * share(engine), radians * share(engine)};
}

std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& places) {
  std::vector<PlaceFrame> frames;
  for (const PlaceId id : places) frames.push_back({placePose(id)});
  return frames;
}

Recognition ask(const Recognizer& recognizer, const Scan& scan, const PlaceIndex& places,
                double heading_window) {
  return recognizer.recognize(scan, places, framesOf, heading_window).value();
}

void expectValid(const Recognition& recognition, const PlaceIndex& places) {
  ASSERT_EQ(recognition.matches.size(), places.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < recognition.matches.size(); ++i) {
    const PlaceMatch& match = recognition.matches[i];
    EXPECT_TRUE(std::isfinite(match.score));
    EXPECT_TRUE(match.place_from_scan.isFinite());
    EXPECT_GE(match.probability, 0.0);
    EXPECT_LE(match.probability, 1.0);
    sum += match.probability;
    if (i == 0) continue;
    const PlaceMatch& better = recognition.matches[i - 1];
    EXPECT_GE(better.score, match.score);
    EXPECT_GE(better.probability, match.probability);
    EXPECT_TRUE(better.score > match.score || better.id < match.id);
  }
  EXPECT_LE(sum, 1.0 + 1e-9);
  EXPECT_TRUE(recognition.map_from_robot.isFinite());
  for (const double entry : recognition.covariance) EXPECT_TRUE(std::isfinite(entry));
}

void expectSamePose(const Pose2d& actual, const Pose2d& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-9);
  EXPECT_NEAR(actual.y, expected.y, 1e-9);
  EXPECT_NEAR(wrapAngle(actual.yaw - expected.yaw), 0.0, 1e-9);
}

void expectSame(const Recognition& a, const Recognition& b) {
  EXPECT_EQ(a.verdict, b.verdict);
  ASSERT_EQ(a.matches.size(), b.matches.size());
  for (std::size_t i = 0; i < a.matches.size(); ++i) {
    EXPECT_EQ(a.matches[i].id, b.matches[i].id);
    EXPECT_EQ(a.matches[i].score, b.matches[i].score);
    EXPECT_EQ(a.matches[i].probability, b.matches[i].probability);
    expectSamePose(a.matches[i].place_from_scan, b.matches[i].place_from_scan);
  }
  expectSamePose(a.map_from_robot, b.map_from_robot);
  EXPECT_EQ(a.covariance, b.covariance);
}

TEST(Recognizer, RanksTheTruePlaceFirst) {
  const PlaceIndex places = rooms(12);
  const Recognizer recognizer(usualOptions());
  std::mt19937 engine(17);
  for (PlaceId id = 1; id <= 12; ++id) {
    const Recognition recognition =
        ask(recognizer, scanIn(id, randomPose(engine, 0.6, 0.25)), places, kWindow);
    expectValid(recognition, places);
    ASSERT_FALSE(recognition.matches.empty());
    EXPECT_EQ(recognition.matches.front().id, id);
  }
}

TEST(Recognizer, RanksTheTruePlaceFirstAtAnyHeading) {
  const PlaceIndex places = rooms(5);
  const Recognizer recognizer(usualOptions());
  for (PlaceId id = 1; id <= 5; ++id) {
    const Pose2d truth{0.2, -0.2, wrapAngle(1.9 * static_cast<double>(id))};
    const Recognition recognition = ask(recognizer, scanIn(id, truth), places, kPi);
    ASSERT_FALSE(recognition.matches.empty());
    EXPECT_EQ(recognition.matches.front().id, id);
    const double off = recognition.matches.front().place_from_scan.yaw - truth.yaw;
    EXPECT_NEAR(wrapAngle(off), 0.0, 1.5 * kStep);
  }
}

TEST(Recognizer, EveryMethodRanksThePlaceTheRobotStandsIn) {
  const PlaceIndex places = rooms(6);
  for (const SearchMethod method : kMethods) {
    const Recognizer recognizer(optionsWith(method));
    for (PlaceId id = 1; id <= 6; ++id) {
      const Recognition recognition = ask(recognizer, scanIn(id, {}), places, 0.1);
      expectValid(recognition, places);
      ASSERT_FALSE(recognition.matches.empty());
      EXPECT_EQ(recognition.matches.front().id, id);
      expectSamePose(recognition.matches.front().place_from_scan, {});
    }
  }
}

TEST(Recognizer, ThePosePutsTheRobotWhereItStands) {
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

TEST(Recognizer, TheCovarianceIsSymmetricWithVariancesAboveZero) {
  const Recognition recognition = ask(Recognizer(usualOptions()), scanIn(2, {}), rooms(3), kWindow);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_GT(recognition.covariance[4 * r], 0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(recognition.covariance[3 * r + c], recognition.covariance[3 * c + r], 1e-12);
    }
  }
}

TEST(Recognizer, WorksAtAnyCellSize) {
  for (const double cell_size : {0.05, 0.1, 0.3}) {
    const double scale = cell_size / kDefaultCellSize;
    const PlaceIndex places = rooms(4, scale, cell_size);
    RecognizerOptions options = usualOptions();
    options.position_window = 1.2 * scale;
    const Recognizer recognizer(options);
    for (unsigned id = 1; id <= 4; ++id) {
      const Pose2d truth{0.4 * scale, -0.3 * scale, 0.15};
      const Scan scan = RandomRoom(id, scale).scanFrom(truth, cell_size);
      const Recognition recognition = ask(recognizer, scan, places, kWindow);
      ASSERT_FALSE(recognition.matches.empty());
      EXPECT_EQ(recognition.matches.front().id, id);
      EXPECT_NEAR(recognition.matches.front().place_from_scan.x, truth.x, 1.5 * cell_size);
      EXPECT_NEAR(recognition.matches.front().place_from_scan.y, truth.y, 1.5 * cell_size);
      EXPECT_NEAR(recognition.matches.front().place_from_scan.yaw, truth.yaw, 1.5 * kStep);
    }
  }
}

TEST(Recognizer, AlignmentsStayInTheWindows) {
  const PlaceIndex places = rooms(6);
  RecognizerOptions options = usualOptions();
  options.position_window = 3.0 * kDefaultCellSize;
  for (const SearchMethod method : kMethods) {
    options.method = method;
    const Recognizer recognizer(options);
    for (const double window : {0.0, 2.0 * kStep, kWindow}) {
      const Recognition recognition = ask(recognizer, scanIn(3, {1.0, -1.0, 0.8}), places, window);
      for (const PlaceMatch& match : recognition.matches) {
        // The search may round the windows up to whole cells and steps.
        EXPECT_LE(std::abs(match.place_from_scan.x), 4.01 * kDefaultCellSize);
        EXPECT_LE(std::abs(match.place_from_scan.y), 4.01 * kDefaultCellSize);
        EXPECT_LE(std::abs(match.place_from_scan.yaw), window + kStep);
      }
    }
  }
}

TEST(Recognizer, APositionWindowBeyondTheGridIsTheWholeGrid) {
  RecognizerOptions options = optionsWith(SearchMethod::kHillClimbing);
  options.position_window = 1e6;
  const PlaceIndex places = rooms(2);
  const Recognition recognition =
      ask(Recognizer(options), scanIn(2, {0.3, 0.0, 0.0}), places, kWindow);
  expectValid(recognition, places);
}

TEST(Recognizer, WithoutPlacesNothingIsKnown) {
  for (const SearchMethod method : kMethods) {
    const Recognition recognition =
        ask(Recognizer(optionsWith(method)), scanIn(1, {}), PlaceIndex(), kWindow);
    EXPECT_EQ(recognition.verdict, Verdict::kUnknown);
    EXPECT_TRUE(recognition.matches.empty());
    expectSamePose(recognition.map_from_robot, {});
  }
}

TEST(Recognizer, AScanThatSensedNothingIsNotRecognized) {
  for (const int count : {1, 5}) {
    const PlaceIndex places = rooms(count);
    for (const SearchMethod method : kMethods) {
      for (const PairWeights& weights : {kPaperWeights, usualOptions().metric.weights}) {
        RecognizerOptions options = optionsWith(method);
        options.metric.weights = weights;
        const Recognition recognition = ask(Recognizer(options), Scan(), places, kWindow);
        expectValid(recognition, places);
        EXPECT_NE(recognition.verdict, Verdict::kRecognized);
      }
    }
  }
}

TEST(Recognizer, PlacesThatSensedNothingAreTakenInStride) {
  PlaceIndex places;
  places.put(1, EvidenceGrid());
  places.put(2, EvidenceGrid());
  for (const SearchMethod method : kMethods) {
    const Recognizer recognizer(optionsWith(method));
    expectValid(ask(recognizer, scanIn(1, {}), places, kWindow), places);
    const Recognition nothing = ask(recognizer, Scan(), places, kWindow);
    expectValid(nothing, places);
    EXPECT_NE(nothing.verdict, Verdict::kRecognized);
  }
}

TEST(Recognizer, OfEqualPlacesTheLowerIdComesFirst) {
  const EvidenceGrid grid = scanIn(7, {}).grid;
  PlaceIndex places;
  for (const PlaceId id : {90, 4, 17, 200, 5}) places.put(id, grid);
  for (const SearchMethod method : kMethods) {
    const Recognition recognition =
        ask(Recognizer(optionsWith(method)), scanIn(7, {}), places, kWindow);
    ASSERT_EQ(recognition.matches.size(), 5U);
    const PlaceId expected[] = {4, 5, 17, 90, 200};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(recognition.matches[i].id, expected[i]);
    expectSamePose(recognition.map_from_robot,
                   placePose(4) * recognition.matches.front().place_from_scan);
    EXPECT_NE(recognition.verdict, Verdict::kRecognized);  // it could be any of them
  }
}

TEST(Recognizer, GivesTheSameAnswerEachTime) {
  const PlaceIndex places = rooms(8);
  const Scan scan = scanIn(3, {0.4, -0.5, 0.2});
  for (const SearchMethod method : kMethods) {
    const Recognizer first(optionsWith(method));
    const Recognizer second(optionsWith(method));
    const Recognition recognition = ask(first, scan, places, kWindow);
    expectSame(recognition, ask(first, scan, places, kWindow));
    expectSame(recognition, ask(second, scan, places, kWindow));
  }
}

TEST(Recognizer, TheOrderOfLearningDoesNotMatter) {
  PlaceIndex backwards;
  for (int id = 8; id >= 1; --id) {
    backwards.put(id, RandomRoom(static_cast<unsigned>(id)).scanFrom({}).grid);
  }
  const Recognizer recognizer(usualOptions());
  const Scan scan = scanIn(3, {0.4, -0.5, 0.2});
  expectSame(ask(recognizer, scan, rooms(8), kWindow), ask(recognizer, scan, backwards, kWindow));
}

TEST(Recognizer, AsksOnceForTheFramesOfThePlacesThatRankFirst) {
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

TEST(Recognizer, HasNoAnswerWhereAPlaceIsGone) {
  const auto gone = [](const std::vector<PlaceId>&) {
    return std::optional<std::vector<PlaceFrame>>();
  };
  EXPECT_FALSE(Recognizer(usualOptions()).recognize(scanIn(1, {}), rooms(3), gone, kWindow));
}

TEST(Recognizer, ThePoseLiesInTheFrameOfTheMatchedPlacesSession) {
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

}  // namespace
}  // namespace place_memory::core
