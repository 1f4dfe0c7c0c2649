#include <gtest/gtest.h>
#include <sqlite3.h>

#include <limits>
#include <thread>

#include "core/random_room.h"
#include "core/temporary_folder.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {
namespace {

constexpr double kHeadingWindow = 0.3;

/// Scans of rooms that end one second after the other.
class AdaptationTest : public testing::Test {
 protected:
  Scan look(const RandomRoom& room, const Pose2d& from = {}) {
    Scan scan = room.scanFrom(from);
    scan.end = std::chrono::seconds(++seconds_);
    return scan;
  }

  // Whatever fits best is recognized: what verdicts are worth is another matter.
  PlaceMemoryOptions options(bool enabled = true) const {
    PlaceMemoryOptions options;
    options.recognizer.calibration.right = {20.0};
    options.adaptation.enabled = enabled;
    options.store_path = store_;
    return options;
  }

  static Recognition recognizedAs(PlaceId id, const Pose2d& place_from_scan = {}) {
    Recognition recognition;
    recognition.verdict = Verdict::kRecognized;
    recognition.matches = {{id, 1.0, place_from_scan, 0.99}};
    return recognition;
  }

  const TemporaryFolder folder_;
  const std::string store_ = folder_.file("places.db");
  const RandomRoom before_{1};
  const RandomRoom after_{2};
  int seconds_ = 0;
};

TEST_F(AdaptationTest, APlaceBecomesWhatItIsRecognizedIn) {
  PlaceMemory memory(options());
  const PlaceId id = memory.learn(look(before_), "a").id;
  for (int visit = 0; visit < 12; ++visit) {
    EXPECT_TRUE(memory.adapt(look(after_), recognizedAs(id)));
  }
  const EvidenceGrid now = after_.scanFrom({}).grid;
  const EvidenceGrid learned = memory.grid(id);
  for (std::size_t i = 0; i < now.cells().size(); ++i) {
    const int sensed = now.cells()[i];
    if (std::abs(sensed) <= 4) continue;
    EXPECT_GT(learned.cells()[i] * sensed, 0) << "cell " << i;
  }
}

TEST_F(AdaptationTest, MatchingSeesTheAdaptedGridAtOnce) {
  PlaceMemory memory(options());
  const PlaceId id = memory.learn(look(before_), "a").id;
  const Scan changed = look(after_);
  const double first = memory.recognize(changed, kHeadingWindow).recognition.matches[0].score;
  for (int visit = 0; visit < 6; ++visit) memory.adapt(look(after_), recognizedAs(id));
  const LabelledRecognition answer = memory.recognize(changed, kHeadingWindow);
  EXPECT_GT(answer.recognition.matches[0].score, first);
  EXPECT_EQ(answer.recognition.verdict, Verdict::kRecognized);
}

TEST_F(AdaptationTest, TheScanIsLaidWhereItAligns) {
  PlaceMemory memory(options());
  const Pose2d away{0.35, -0.2, 0.15};
  const PlaceId id = memory.learn(look(before_), "a").id;
  const EvidenceGrid learned = memory.grid(id);
  const LabelledRecognition answer = memory.recognize(look(before_, away), kHeadingWindow);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  ASSERT_TRUE(memory.adapt(look(before_, away), answer.recognition));
  int clear = 0;
  int kept = 0;
  for (std::size_t i = 0; i < learned.cells().size(); ++i) {
    if (std::abs(learned.cells()[i]) < 40) continue;
    ++clear;
    if (learned.cells()[i] * memory.grid(id).cells()[i] > 0) ++kept;
    if (clear == 300) break;
  }
  EXPECT_GT(kept, 0.95 * clear);
}

TEST_F(AdaptationTest, ThePlaceStaysWhereItIs) {
  PlaceMemory memory(options());
  Scan scan = look(before_);
  scan.odom_from_scan = {3.0, 4.0, 0.5};
  const PlaceId id = memory.learn(scan, "a").id;
  scan = look(before_);
  scan.odom_from_scan = {9.0, 9.0, 0.0};
  ASSERT_TRUE(memory.adapt(scan, recognizedAs(id, {0.1, 0.1, 0.1})));
  EXPECT_EQ(memory.place(id)->map_from_place.x, 3.0);
  EXPECT_EQ(memory.place(id)->learned, std::chrono::seconds(1));
}

TEST_F(AdaptationTest, OnlyWhatWasRecognizedIsFolded) {
  PlaceMemory memory(options());
  const PlaceId id = memory.learn(look(before_), "a").id;
  const EvidenceGrid learned = memory.grid(id);
  for (const Verdict verdict : {Verdict::kUnknown, Verdict::kAmbiguous}) {
    Recognition recognition = recognizedAs(id);
    recognition.verdict = verdict;
    EXPECT_FALSE(memory.adapt(look(after_), recognition));
  }
  EXPECT_FALSE(memory.adapt(look(after_), Recognition{}));
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, NothingIsFoldedUnlessAskedFor) {
  PlaceMemory memory(options(false));
  const PlaceId id = memory.learn(look(before_), "a").id;
  const EvidenceGrid learned = memory.grid(id);
  EXPECT_FALSE(memory.adapt(look(after_), recognizedAs(id)));
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, AScanIsEvidenceOnce) {
  PlaceMemory memory(options());
  const Scan first = look(before_);
  const PlaceId id = memory.learn(first, "a").id;
  EXPECT_FALSE(memory.adapt(first, recognizedAs(id)));
  const Scan second = look(after_);
  EXPECT_TRUE(memory.adapt(second, recognizedAs(id)));
  const EvidenceGrid learned = memory.grid(id);
  EXPECT_FALSE(memory.adapt(second, recognizedAs(id)));
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, AdaptedPlacesSurviveARestart) {
  EvidenceGrid adapted;
  double score = 0.0;
  const Scan changed = look(after_);
  {
    PlaceMemory memory(options());
    const PlaceId id = memory.learn(look(before_), "a").id;
    memory.adapt(look(after_), recognizedAs(id));
    adapted = memory.grid(id);
    EXPECT_FALSE(adapted == before_.scanFrom({}).grid);
    score = memory.recognize(changed, kHeadingWindow).recognition.matches[0].score;
  }
  PlaceMemory memory(options());
  EXPECT_EQ(memory.grid(1), adapted);
  EXPECT_EQ(memory.recognize(changed, kHeadingWindow).recognition.matches[0].score, score);
}

TEST_F(AdaptationTest, APlaceThatIsGoneIsNotBroughtBack) {
  PlaceMemory memory(options());
  const PlaceId id = memory.learn(look(before_), "a").id;
  memory.remove("a");
  EXPECT_FALSE(memory.adapt(look(after_), recognizedAs(id)));
  EXPECT_EQ(memory.size(), 0U);
  EXPECT_TRUE(memory.recognize(look(after_), kHeadingWindow).labels.empty());
}

TEST_F(AdaptationTest, PlacesComeAndGoWhileTheyAdapt) {
  PlaceMemory memory(options());
  const PlaceId stays = memory.learn(look(before_), "stays").id;
  std::vector<Scan> scans;
  for (int i = 0; i < 60; ++i) scans.push_back(look(after_));
  std::thread editor([&] {
    for (int i = 0; i < 30; ++i) {
      memory.learn(before_.scanFrom({}), "goes");
      memory.remove("goes");
    }
  });
  for (const Scan& scan : scans) memory.adapt(scan, recognizedAs(memory.graph().lastId()));
  editor.join();
  EXPECT_EQ(memory.size(), 1U);
  EXPECT_TRUE(memory.adapt(look(after_), recognizedAs(stays)));
  EXPECT_EQ(memory.recognize(look(after_), kHeadingWindow).labels,
            std::vector<std::string>{"stays"});
}

TEST_F(AdaptationTest, WhatCannotBeStoredChangesNothing) {
  PlaceMemory(options()).learn(look(before_), "a");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(store_.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database,
                         "CREATE TRIGGER full AFTER UPDATE ON grid BEGIN SELECT RAISE(ABORT, "
                         "'full'); END",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  PlaceMemory memory(options());
  const Scan scan = look(after_);
  const double score = memory.recognize(scan, kHeadingWindow).recognition.matches[0].score;
  try {
    memory.adapt(scan, recognizedAs(1));
    FAIL() << "nothing was refused";
  } catch (const PlaceMemoryError& error) {
    EXPECT_EQ(error.reason(), PlaceMemoryError::Reason::kStoreFailed);
  }
  EXPECT_EQ(memory.grid(1), before_.scanFrom({}).grid);
  EXPECT_EQ(memory.recognize(scan, kHeadingWindow).recognition.matches[0].score, score);
}

TEST_F(AdaptationTest, RefusesARetentionOutOfRange) {
  for (const double retention : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    PlaceMemoryOptions wrong = options();
    wrong.adaptation.retention = retention;
    EXPECT_THROW(PlaceMemory{wrong}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace place_memory::core
