#include "core/recognize/recognizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/recognize/rooms.h"

namespace place_memory::core {
namespace {

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

TEST(Recognizer, AScanWithoutAnEchoIsUnknownHoweverWellItsEmptyCellsAgree) {
  Scan silent = scanIn(1, {});
  for (SonarReading& reading : silent.readings) reading.range = INFINITY;
  silent.grid = SonarModel({}).build(silent.readings, {});
  PlaceIndex places = rooms(3);
  places.put(4, silent.grid);
  for (const SearchMethod method : kMethods) {
    RecognizerOptions options = optionsWith(method);
    options.calibration.right = {20.0};  // any other scan is taken for its best match
    options.calibration.known = {20.0};
    const Recognizer recognizer(options);
    const Recognition found = ask(recognizer, silent, places, kWindow);
    EXPECT_TRUE(found.no_echo);
    EXPECT_EQ(found.verdict, Verdict::kUnknown);
    ASSERT_EQ(found.matches.size(), 4U);
    for (const PlaceMatch& match : found.matches) EXPECT_EQ(match.probability, 0.0);
    const Recognition heard = ask(recognizer, scanIn(1, {}), places, kWindow);
    EXPECT_FALSE(heard.no_echo);
    EXPECT_EQ(heard.verdict, Verdict::kRecognized);
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

TEST(Recognizer, AnswersTheSameWithAnyNumberOfThreads) {
  const PlaceIndex places = rooms(40);
  const Scan scan = scanIn(3, {0.4, -0.5, 0.2});
  RecognizerOptions options = usualOptions();
  const Recognition recognition = ask(Recognizer(options), scan, places, kPi);
  for (const std::size_t threads : {1U, 2U, 7U}) {
    options.threads = threads;
    expectSame(recognition, ask(Recognizer(options), scan, places, kPi));
  }
}

}  // namespace
}  // namespace place_memory::core
