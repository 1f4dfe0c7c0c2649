#include <gtest/gtest.h>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;
using Labels = std::vector<std::string>;

class UndoTest : public PlaceMemoryTest {
 protected:
  Labels history() const {
    Labels words;
    for (const PastChange& change : memory_.history(100)) words.push_back(change.words);
    return words;
  }

  Reason reasonOfUndo(std::size_t count) {
    try {
      memory_.undo(count);
    } catch (const PlaceMemoryError& error) {
      return error.reason();
    }
    ADD_FAILURE() << "was undone";
    return Reason::kStoreFailed;
  }
};

TEST_F(UndoTest, TakesBackEveryKindOfChangeOneAfterTheOther) {
  learn(1, "a");
  learn(2, "b");
  memory_.rename("b", "c");
  memory_.remove("a");
  memory_.clear();
  EXPECT_EQ(history(), (Labels{"removed all 1 places", "removed \"a\"", "renamed \"b\" to \"c\"",
                               "learned \"b\"", "learned \"a\""}));
  EXPECT_EQ(memory_.undo().front().words, "removed all 1 places");
  EXPECT_EQ(labels(), Labels{"c"});
  memory_.undo();
  EXPECT_EQ(labels(), (Labels{"a", "c"}));
  EXPECT_EQ(links(), (std::vector<Ends>{{1, 2}}));
  memory_.undo();
  EXPECT_EQ(labels(), (Labels{"a", "b"}));
  memory_.undo(2);
  EXPECT_TRUE(labels().empty());
  EXPECT_TRUE(history().empty());
}

TEST_F(UndoTest, APlaceThatComesBackIsRecognizedAgain) {
  learn(1, "a");
  learn(2, "b");
  const Place before = *memory_.place(1);
  memory_.remove("a");
  memory_.undo();
  EXPECT_TRUE(*memory_.place(1) == before);
  EXPECT_EQ(memory_.grid(1), makeRandomScan(1).grid);
  const PlaceMemory::Answer answer = recognize(1);
  ASSERT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  EXPECT_EQ(answer.labels.front(), "a");
}

TEST_F(UndoTest, IsOneChangeThatListenersHearOf) {
  learn(1, "a");
  memory_.rename("a", "b");
  std::vector<MapChange> heard;
  memory_.listen([&heard](const MapChange& change) { heard.push_back(change); });
  const std::uint64_t version = memory_.version();
  memory_.undo(2);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard.front().version, version + 1);
}

TEST_F(UndoTest, OfMoreThanThereIsChangesNothing) {
  EXPECT_EQ(reasonOfUndo(1), Reason::kNothingToUndo);
  learn(1, "a");
  EXPECT_EQ(reasonOfUndo(2), Reason::kNothingToUndo);
  EXPECT_EQ(labels(), Labels{"a"});
}

TEST_F(UndoTest, OutlivesARestart) {
  const TemporaryFolder folder;
  PlaceMemoryOptions kept = options();
  kept.store_path = folder.file("places.db");
  {
    PlaceMemory memory(kept);
    memory.learn(makeRandomScan(1), "a");
    memory.remove("a");
  }
  PlaceMemory memory(kept);
  EXPECT_EQ(memory.undo().front().words, "removed \"a\"");
  EXPECT_EQ(memory.map().places.front().label, "a");
}

}  // namespace
}  // namespace place_memory::core
