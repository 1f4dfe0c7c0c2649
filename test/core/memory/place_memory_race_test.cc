#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "core/memory/place_memory_fixture.h"

// What happens to the memory while a match runs.
namespace place_memory::core {
namespace {

TEST_F(PlaceMemoryTest, APlaceRemovedDuringTheMatchIsNotInTheAnswer) {
  learn(1, "a");
  learn(2, "b");
  bool removed = false;
  const PlaceMemory::Answer answer = recognize(1, [&] {
    if (!removed) memory_.remove("a");
    removed = true;
    return false;
  });
  ASSERT_TRUE(removed);
  EXPECT_EQ(answer.labels, std::vector<std::string>{"b"});
  EXPECT_NE(answer.recognition.verdict, Verdict::kRecognized);
}

TEST_F(PlaceMemoryTest, APlaceLearnedDuringTheMatchComesToTheNextOne) {
  learn(1, "a");
  bool learned = false;
  const PlaceMemory::Answer answer = recognize(2, [&] {
    if (!learned) learn(2, "b");
    learned = true;
    return false;
  });
  EXPECT_EQ(answer.labels, std::vector<std::string>{"a"});
  EXPECT_EQ(recognize(2).labels.front(), "b");
}

TEST_F(PlaceMemoryTest, AnAnswerThatANewerOneOvertookLinksNothing) {
  learn(1, "a");
  const auto learnMeanwhile = [this] {
    if (memory_.size() == 1) learn(2, "b");
    return false;
  };
  const PlaceMemory::Answer answer = recognize(1, learnMeanwhile);
  EXPECT_EQ(answer.recognition.verdict, Verdict::kRecognized);
  EXPECT_TRUE(answer.superseded);
  EXPECT_EQ(previous(), "b");
  EXPECT_FALSE(recognize(1).superseded);
  EXPECT_EQ(previous(), "a");
}

TEST_F(PlaceMemoryTest, AnAnswerFromBeforeTheRobotWasCarriedLinksNothing) {
  learn(1, "a");
  const auto carryMeanwhile = [this] {
    memory_.forgetWhereabouts();
    return false;
  };
  EXPECT_TRUE(recognize(1, carryMeanwhile).superseded);
  EXPECT_EQ(previous(), "");
}

TEST_F(PlaceMemoryTest, AMatchCanBeCancelled) {
  learn(1, "a");
  EXPECT_THROW(recognize(1, [] { return true; }), std::runtime_error);
}

TEST_F(PlaceMemoryTest, RecognizesWhileOthersLearnRenameAndRemove) {
  learn(1, "a");
  constexpr int kRounds = 60;
  std::atomic<int> recognized{0};
  std::thread learner([this] {
    for (int i = 0; i < kRounds; ++i) {
      learn(100 + static_cast<unsigned>(i), "passing");
      memory_.rename("passing", "passed");
      memory_.remove("passed");
    }
  });
  std::thread reader([this] {
    for (int i = 0; i < kRounds; ++i) EXPECT_GE(memory_.map().places.size(), 1U);
  });
  std::vector<std::thread> clients;
  clients.reserve(2);
  for (int client = 0; client < 2; ++client) {
    clients.emplace_back([this, &recognized] {
      for (int i = 0; i < kRounds; ++i) {
        const PlaceMemory::Answer answer = recognize(1);
        if (answer.labels.front() == "a") ++recognized;
      }
    });
  }
  learner.join();
  reader.join();
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(recognized, 2 * kRounds);
  EXPECT_EQ(labels(), std::vector<std::string>{"a"});
}

}  // namespace
}  // namespace place_memory::core
