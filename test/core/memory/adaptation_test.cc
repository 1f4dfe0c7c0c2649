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

/// Has the store fail whenever a row of the table is to be written.
void refuseRowsOf(const std::string& store, const std::string& table) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(store.c_str(), &database), SQLITE_OK);
  for (const std::string event : {"UPDATE", "INSERT"}) {
    const std::string trigger = "CREATE TRIGGER full_" + event + " AFTER " + event + " ON " +
                                table + " BEGIN SELECT RAISE(ABORT, 'full'); END";
    ASSERT_EQ(sqlite3_exec(database, trigger.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  }
  sqlite3_close(database);
}

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

  static bool fold(PlaceMemory& memory, const Scan& scan) {
    return memory.recognize(scan, kHeadingWindow).adapted;
  }

  const TemporaryFolder folder_;
  const std::string store_ = folder_.file("places.db");
  const RandomRoom before_{1};
  const RandomRoom after_{2};
  int seconds_ = 0;
};

TEST_F(AdaptationTest, APlaceBecomesWhatItIsRecognizedIn) {
  PlaceMemoryOptions where_it_was = options();
  where_it_was.recognizer.position_window = 1e-3;
  PlaceMemory memory(where_it_was);
  const PlaceId id = memory.learn(look(before_), "a").place.id;
  for (int visit = 0; visit < 12; ++visit) {
    EXPECT_TRUE(memory.recognize(look(after_), 0.0).adapted);
  }
  // It is laid where it matched, which in a changed room is some way off within a cell.
  const EvidenceGrid now = after_.scanFrom({}).grid;
  const EvidenceGrid learned = memory.grid(id);
  int clear = 0;
  int agree = 0;
  for (std::size_t i = 0; i < now.cells().size(); ++i) {
    const int sensed = now.cells()[i];
    if (std::abs(sensed) <= 20) continue;
    ++clear;
    if (learned.cells()[i] * sensed > 0) ++agree;
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(agree, 0.9 * clear);
}

TEST_F(AdaptationTest, MatchingSeesTheAdaptedGridAtOnce) {
  PlaceMemory memory(options());
  memory.learn(look(before_), "a");
  const Scan changed = look(after_);
  const double first = memory.recognize(changed, kHeadingWindow).recognition.matches[0].score;
  for (int visit = 0; visit < 6; ++visit) fold(memory, look(after_));
  const PlaceMemory::Answer answer = memory.recognize(changed, kHeadingWindow);
  EXPECT_GT(answer.recognition.matches[0].score, first);
  EXPECT_EQ(answer.recognition.verdict, Verdict::kRecognized);
}

TEST_F(AdaptationTest, TheScanIsLaidWhereItAligns) {
  PlaceMemory memory(options());
  const Pose2d away{0.35, -0.2, 0.15};
  const PlaceId id = memory.learn(look(before_), "a").place.id;
  const EvidenceGrid learned = memory.grid(id);
  const PlaceMemory::Answer answer = memory.recognize(look(before_, away), kHeadingWindow);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  ASSERT_TRUE(answer.adapted);
  int clear = 0;
  int kept = 0;
  for (std::size_t i = 0; i < learned.cells().size(); ++i) {
    if (std::abs(learned.cells()[i]) < 40) continue;
    ++clear;
    if (learned.cells()[i] * memory.grid(id).cells()[i] > 0) ++kept;
    if (clear == 300) break;
  }
  EXPECT_GT(kept, 0.9 * clear);
}

TEST_F(AdaptationTest, ThePlaceStaysWhereItIs) {
  PlaceMemory memory(options());
  Scan scan = look(before_);
  scan.odom_from_scan = {3.0, 4.0, 0.5};
  const PlaceId id = memory.learn(scan, "a").place.id;
  scan = look(before_, {0.1, 0.1, 0.1});
  scan.odom_from_scan = {9.0, 9.0, 0.0};
  ASSERT_TRUE(fold(memory, scan));
  EXPECT_EQ(memory.place(id)->map_from_place, (Pose2d{3.0, 4.0, 0.5}));
  EXPECT_EQ(memory.place(id)->learned, std::chrono::seconds(1));
}

TEST_F(AdaptationTest, OnlyWhatWasRecognizedIsFolded) {
  PlaceMemoryOptions doubtful = options();
  doubtful.recognizer.calibration.right = {-20.0};
  PlaceMemory memory(doubtful);
  const PlaceId id = memory.learn(look(before_), "a").place.id;
  const EvidenceGrid learned = memory.grid(id);
  const PlaceMemory::Answer answer = memory.recognize(look(after_), kHeadingWindow);
  ASSERT_NE(answer.recognition.verdict, Verdict::kRecognized);
  EXPECT_FALSE(answer.adapted);
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, NothingIsFoldedUnlessAskedFor) {
  PlaceMemory memory(options(false));
  const PlaceId id = memory.learn(look(before_), "a").place.id;
  const EvidenceGrid learned = memory.grid(id);
  EXPECT_FALSE(fold(memory, look(after_)));
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, AScanIsEvidenceOnce) {
  PlaceMemory memory(options());
  const Scan first = look(before_);
  const PlaceId id = memory.learn(first, "a").place.id;
  EXPECT_FALSE(fold(memory, first));
  const Scan second = look(after_);
  EXPECT_TRUE(fold(memory, second));
  const EvidenceGrid learned = memory.grid(id);
  EXPECT_FALSE(fold(memory, second));
  EXPECT_EQ(memory.grid(id), learned);
}

TEST_F(AdaptationTest, AdaptedPlacesSurviveARestart) {
  EvidenceGrid adapted;
  {
    PlaceMemory memory(options());
    const PlaceId id = memory.learn(look(before_), "a").place.id;
    fold(memory, look(after_));
    adapted = memory.grid(id);
    EXPECT_FALSE(adapted == before_.scanFrom({}).grid);
  }
  PlaceMemory memory(options());
  EXPECT_EQ(memory.grid(1), adapted);
  // What is matched is what is stored.
  PlaceMemoryOptions other;
  other.recognizer = options().recognizer;
  PlaceMemory fresh(other);
  Scan scan = look(before_);
  scan.grid = adapted;
  fresh.learn(scan, "a");
  const Scan changed = look(after_);
  EXPECT_EQ(memory.recognize(changed, kHeadingWindow).recognition.matches[0].score,
            fresh.recognize(changed, kHeadingWindow).recognition.matches[0].score);
}

TEST_F(AdaptationTest, APlaceRemovedWhileItIsMatchedIsNotBroughtBack) {
  PlaceMemory memory(options());
  memory.learn(look(before_), "a");
  const auto remove_meanwhile = [&memory] {
    if (memory.size() > 0) memory.remove("a");
    return false;
  };
  const auto answer = memory.recognize(look(after_), kHeadingWindow, remove_meanwhile);
  EXPECT_FALSE(answer.adapted);
  EXPECT_TRUE(answer.labels.empty());
  EXPECT_EQ(memory.size(), 0U);
}

TEST_F(AdaptationTest, PlacesComeAndGoWhileTheyAdapt) {
  PlaceMemory memory(options());
  memory.learn(look(before_), "stays");
  std::vector<Scan> scans;
  for (int i = 0; i < 60; ++i) scans.push_back(look(after_));
  std::thread editor([&] {
    for (int i = 0; i < 30; ++i) {
      memory.learn(before_.scanFrom({}), "goes");
      memory.remove("goes");
    }
  });
  int folded = 0;
  for (const Scan& scan : scans) folded += fold(memory, scan) ? 1 : 0;
  editor.join();
  EXPECT_GT(folded, 0);
  EXPECT_EQ(memory.size(), 1U);
  EXPECT_TRUE(fold(memory, look(after_)));
  EXPECT_EQ(memory.recognize(look(after_), kHeadingWindow).labels,
            std::vector<std::string>{"stays"});
}

TEST_F(AdaptationTest, WhatCannotBeStoredChangesNothingButTheAnswerStands) {
  PlaceMemory(options()).learn(look(before_), "a");
  refuseRowsOf(store_, "grid");
  PlaceMemory memory(options());
  const std::uint64_t version = memory.version();
  const PlaceMemory::Answer answer = memory.recognize(look(after_), kHeadingWindow);
  EXPECT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  EXPECT_FALSE(answer.adapted);
  EXPECT_NE(answer.adapt_problem, "");
  EXPECT_EQ(memory.grid(1), before_.scanFrom({}).grid);
  EXPECT_EQ(memory.version(), version);
  EXPECT_EQ(memory.recognize(look(after_), kHeadingWindow).recognition.matches[0].score,
            answer.recognition.matches[0].score);
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
