#ifndef PLACE_MEMORY_TEST_CORE_RECOGNIZE_ROOMS_H
#define PLACE_MEMORY_TEST_CORE_RECOGNIZE_ROOMS_H

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/random_room.h"
#include "core/recognize/recognizer.h"

/// Places that are rooms, and what recognition answers among them.
namespace place_memory::core {

constexpr double kWindow = 0.35;  ///< of headings [rad]
constexpr double kStep = 3.0 * kPi / 180.0;
constexpr SearchMethod kMethods[] = {SearchMethod::kNearestNeighbour, SearchMethod::kHillClimbing,
                                     SearchMethod::kRestarts, SearchMethod::kExhaustive};

inline RecognizerOptions usualOptions() {
  RecognizerOptions options;
  options.metric.weights = {{{1.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {-2.0, -1.0, 3.0}}};
  return options;
}

inline RecognizerOptions optionsWith(SearchMethod method) {
  RecognizerOptions options = usualOptions();
  options.method = method;
  return options;
}

inline Pose2d placePose(PlaceId id) {
  const auto n = static_cast<double>(id);
  return {3.0 * n, -2.0 * n, 0.4 * n};
}

/// Places 1 to `count`, each a room of its own, sensed from its middle.
inline PlaceIndex rooms(int count, double scale = 1.0, double cell_size = kDefaultCellSize) {
  PlaceIndex index;
  for (int id = 1; id <= count; ++id) {
    const RandomRoom room(static_cast<unsigned>(id), scale);
    index.put(id, room.scanFrom({}, cell_size).grid);
  }
  return index;
}

inline Scan scanIn(PlaceId id, const Pose2d& place_from_scan) {
  return RandomRoom(static_cast<unsigned>(id)).scanFrom(place_from_scan);
}

inline Pose2d randomPose(std::mt19937& engine, double metres, double radians) {
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  return {metres * share(engine), metres * share(engine), radians * share(engine)};
}

inline std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& places) {
  std::vector<PlaceFrame> frames;
  for (const PlaceId id : places) frames.push_back({placePose(id)});
  return frames;
}

inline Recognition ask(const Recognizer& recognizer, const Scan& scan, const PlaceIndex& places,
                       double heading_window) {
  return recognizer.recognize(scan, places, framesOf, heading_window).value();
}

inline void expectValid(const Recognition& recognition, const PlaceIndex& places) {
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

inline void expectSamePose(const Pose2d& actual, const Pose2d& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-9);
  EXPECT_NEAR(actual.y, expected.y, 1e-9);
  EXPECT_NEAR(wrapAngle(actual.yaw - expected.yaw), 0.0, 1e-9);
}

inline void expectSame(const Recognition& a, const Recognition& b) {
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

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_RECOGNIZE_ROOMS_H
