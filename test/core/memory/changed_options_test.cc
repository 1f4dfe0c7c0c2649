#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

#include "core/random_room.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {
namespace {

constexpr double kQuarter = kPi / 2.0;

/// Options that are changed between questions, and while one is asked.
class ChangedOptionsTest : public testing::Test {
 protected:
  ChangedOptionsTest() {
    // Whatever fits best is recognized: what verdicts are worth is another matter.
    options_.recognizer.calibration.right = {20.0};
    options_.recognizer.heading_window = 0.1;
  }

  Scan look(const Pose2d& from = {}) {
    Scan scan = room_.scanFrom(from);
    scan.end = std::chrono::seconds(++seconds_);
    return scan;
  }

  PlaceMemoryOptions options_;
  const RandomRoom room_{1};
  int seconds_ = 0;
};

TEST_F(ChangedOptionsTest, TheNewWindowHoldsFromTheNextQuestionOn) {
  PlaceMemory memory(options_);
  memory.learn(look(), "a");
  const Scan turned = look({0.0, 0.0, kQuarter});
  const auto seen = [&] {
    return std::abs(memory.recognize(turned, {}).recognition.matches[0].place_from_scan.yaw);
  };
  EXPECT_LT(seen(), 0.2);
  options_.recognizer.heading_window = kPi;
  memory.setOptions(options_.recognizer, options_.adaptation);
  EXPECT_NEAR(seen(), kQuarter, 0.1);
}

TEST_F(ChangedOptionsTest, AWindowThatIsAskedForHoldsAllTheSame) {
  options_.recognizer.heading_window = kPi;
  PlaceMemory memory(options_);
  memory.learn(look(), "a");
  const Scan turned = look({0.0, 0.0, kQuarter});
  EXPECT_LT(std::abs(memory.recognize(turned, 0.1).recognition.matches[0].place_from_scan.yaw),
            0.2);
}

TEST_F(ChangedOptionsTest, PlacesAdaptOnceTheyAreToldTo) {
  PlaceMemory memory(options_);
  memory.learn(look(), "a");
  EXPECT_FALSE(memory.recognize(look(), {}).adapted);
  memory.setOptions(options_.recognizer, {true, 0.5});
  EXPECT_TRUE(memory.recognize(look(), {}).adapted);
  memory.setOptions(options_.recognizer, {false, 0.5});
  EXPECT_FALSE(memory.recognize(look(), {}).adapted);
}

TEST_F(ChangedOptionsTest, WhatIsOutOfRangeChangesNothing) {
  PlaceMemory memory(options_);
  memory.learn(look(), "a");
  RecognizerOptions wrong = options_.recognizer;
  wrong.confidence = 1.0;
  EXPECT_THROW(memory.setOptions(wrong, {true, 0.5}), std::invalid_argument);
  wrong = options_.recognizer;
  wrong.heading_window = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(memory.setOptions(wrong, {true, 0.5}), std::invalid_argument);
  EXPECT_THROW(memory.setOptions(options_.recognizer, {true, 1.0}), std::invalid_argument);
  EXPECT_FALSE(memory.recognize(look(), {}).adapted);
}

TEST_F(ChangedOptionsTest, ChangesMayComeWhileScansAreRecognized) {
  PlaceMemory memory(options_);
  memory.learn(look(), "a");
  std::atomic<bool> done{false};
  std::thread changing([&] {
    for (int i = 0; !done; ++i) {
      RecognizerOptions options = options_.recognizer;
      options.confidence = i % 2 == 0 ? 0.6 : 0.9;
      options.threads = static_cast<std::size_t>(1 + i % 2);
      memory.setOptions(options, {i % 2 == 0, 0.5});
    }
  });
  for (int visit = 0; visit < 20; ++visit) {
    EXPECT_EQ(memory.recognize(look(), {}).recognition.verdict, Verdict::kRecognized);
  }
  done = true;
  changing.join();
}

}  // namespace
}  // namespace place_memory::core
