#include "tools/result_table.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <sstream>

#include "core/random_room.h"
#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

core::Scan look(unsigned room, int second) {
  core::Scan scan = core::RandomRoom(room).scanFrom({});
  scan.end = std::chrono::seconds(second);
  return scan;
}

Event event(Action action, const std::string& label = "") {
  Event event;
  event.action = action;
  event.label = label;
  event.heading_window = 0.3;
  return event;
}

/// Whatever fits best is recognized: what verdicts are worth is another matter.
core::PlaceMemoryOptions adapting(bool enabled, const std::string& store = "") {
  core::PlaceMemoryOptions options;
  options.recognizer.calibration.right = {20.0};
  options.store_path = store;
  options.adaptation.enabled = enabled;
  return options;
}

TEST(ResultTable, APlaceFollowsWhatIsRecognizedWhereItIsAskedTo) {
  for (const bool enabled : {false, true}) {
    core::PlaceMemory memory(adapting(enabled));
    ASSERT_EQ(run(event(Action::kLearn, "a"), look(1, 1), memory).status, "ok");
    const core::EvidenceGrid learned = memory.grid(1);
    const Result result = run(event(Action::kRecognize), look(1, 2), memory);
    EXPECT_EQ(result.status, "ok");
    EXPECT_EQ(result.verdict, "recognized");
    EXPECT_EQ(result.message, "");
    EXPECT_EQ(memory.grid(1) == learned, !enabled);
  }
}

TEST(ResultTable, AScanWithoutAnEchoIsLearnedOnlyWhereTheTableForcesIt) {
  core::PlaceMemory memory(adapting(false));
  core::Scan silent;
  silent.end = std::chrono::seconds(1);
  Event learning = event(Action::kLearn, "a");
  const Result refused = run(learning, silent, memory);
  EXPECT_EQ(refused.status, "no_echo");
  EXPECT_NE(refused.message.find("force"), std::string::npos) << refused.message;
  EXPECT_TRUE(memory.map().places.empty());
  learning.force = true;
  EXPECT_EQ(run(learning, silent, memory).status, "ok");
  EXPECT_EQ(memory.map().places.size(), 1U);

  const Result asked = run(event(Action::kRecognize), silent, memory);
  EXPECT_EQ(asked.verdict, "unknown");
  EXPECT_EQ(asked.probability, 0.0);
  EXPECT_NE(asked.message.find("no echo"), std::string::npos) << asked.message;
}

TEST(ResultTable, AnAnswerStandsThoughThePlaceCannotFollow) {
  const TemporaryFolder folder;
  core::PlaceMemory memory(adapting(true, folder.file("places.db")));
  run(event(Action::kLearn, "a"), look(1, 1), memory);
  // As with a disk that is full.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit none{0, limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  const Result result = run(event(Action::kRecognize), look(1, 2), memory);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_EQ(result.status, "ok");
  EXPECT_EQ(result.verdict, "recognized");
  EXPECT_EQ(result.place, "a");
  EXPECT_NE(result.message.find("as it was"), std::string::npos) << result.message;
}

TEST(ResultTable, WhatDoesNotApplyIsEmpty) {
  core::PlaceMemory memory(adapting(false));
  std::ostringstream table;
  const Event asked = event(Action::kRecognize);
  writeRow(asked, run(asked, look(1, 1), memory), table);
  EXPECT_EQ(table.str().substr(0, 30), "0.000,recognize,ok,unknown,,,,");
}

}  // namespace
}  // namespace place_memory::tools
