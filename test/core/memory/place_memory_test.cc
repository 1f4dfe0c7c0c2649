#include "place_memory/core/place_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;

template <class Call>
void expectRefused(Reason reason, const Call& call) {
  try {
    call();
    FAIL() << "nothing was refused";
  } catch (const PlaceMemoryError& error) {
    EXPECT_EQ(error.reason(), reason) << error.what();
  }
}

TEST_F(PlaceMemoryTest, KnowsNothingAtFirst) {
  EXPECT_EQ(memory_.size(), 0U);
  EXPECT_EQ(previous(), "");
  const PlaceMemory::Answer answer = recognize(1);
  EXPECT_EQ(answer.recognition.verdict, Verdict::kUnknown);
  EXPECT_TRUE(answer.recognition.matches.empty());
}

TEST_F(PlaceMemoryTest, APlaceIsItsScan) {
  const Scan scan = makeRandomScan(1);
  const Place place = memory_.learn(scan, "kitchen").place;
  EXPECT_EQ(place.label, "kitchen");
  EXPECT_EQ(place.learned, scan.end);
  EXPECT_EQ(place.map_from_place.x, scan.odom_from_scan.x);
  EXPECT_EQ(place.map_from_place.y, scan.odom_from_scan.y);
  EXPECT_EQ(place.map_from_place.yaw, scan.odom_from_scan.yaw);
  EXPECT_EQ(memory_.grid(place.id), scan.grid);
  ASSERT_TRUE(memory_.place(place.id));
  EXPECT_EQ(memory_.place(place.id)->label, "kitchen");
}

TEST_F(PlaceMemoryTest, RecognizesEveryPlaceItLearned) {
  for (unsigned seed = 1; seed <= 8; ++seed) learn(seed, "place of " + std::to_string(seed));
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const PlaceMemory::Answer answer = recognize(seed);
    EXPECT_EQ(answer.recognition.verdict, Verdict::kRecognized);
    ASSERT_EQ(answer.labels.size(), 8U);
    EXPECT_EQ(answer.labels.front(), "place of " + std::to_string(seed));
    EXPECT_EQ(memory_.place(answer.recognition.matches.back().id)->label, answer.labels.back());
  }
}

TEST_F(PlaceMemoryTest, AnOddScanDoesNotMakeAPlace) {
  Scan scan = makeRandomScan(1);
  scan.odom_from_scan.x = std::numeric_limits<double>::quiet_NaN();
  expectRefused(Reason::kInvalidScan, [&] { memory_.learn(scan, "a"); });
  EXPECT_EQ(memory_.size(), 0U);
}

TEST_F(PlaceMemoryTest, RefusesAScanThatIsNotToBeReliedOn) {
  Scan scan = makeRandomScan(1);
  scan.doubt = "the compass stands still";
  expectRefused(Reason::kDoubtfulScan, [&] { memory_.learn(scan, "a"); });
  EXPECT_EQ(memory_.size(), 0U);
  memory_.learn(scan, "a", true);
  EXPECT_EQ(memory_.size(), 1U) << "with force";
}

TEST_F(PlaceMemoryTest, RefusesAScanOfOtherCells) {
  const Scan scan = makeRandomScan(1, 0.2);
  expectRefused(Reason::kWrongCells, [&] { memory_.learn(scan, "a"); });
  expectRefused(Reason::kWrongCells, [&] { memory_.recognize(scan, kHeadingWindow); });
  EXPECT_EQ(memory_.size(), 0U);
}

TEST_F(PlaceMemoryTest, AScanBecomesAPlaceOnce) {
  Scan numbered = makeRandomScan(1);
  numbered.id = 7;
  Scan stamped = makeRandomScan(2);
  stamped.begin = std::chrono::seconds(5);
  for (const Scan& scan : {numbered, stamped}) {
    const Place place = memory_.learn(scan, "").place;
    expectRefused(Reason::kAlreadyLearned, [&] { memory_.learn(scan, "again"); });
    expectRefused(Reason::kLabelTaken, [&] { memory_.learn(scan, place.label); });
    memory_.remove(place.label);
    EXPECT_NO_THROW(memory_.learn(scan, ""));
  }
  EXPECT_EQ(memory_.size(), 2U);
}

TEST_F(PlaceMemoryTest, WhatIsAnotherScanIsAnotherPlace) {
  Scan scan = makeRandomScan(1);
  scan.id = 7;
  memory_.learn(scan, "a");
  scan.id = 8;
  EXPECT_NO_THROW(memory_.learn(scan, "the same spot, scanned again"));
  scan.odom_from_scan.x += 1.0;
  EXPECT_NO_THROW(memory_.learn(scan, "elsewhere"));
  scan.id = 0;
  EXPECT_NO_THROW(memory_.learn(scan, "without an id"));
  scan.end += std::chrono::seconds(1);
  EXPECT_NO_THROW(memory_.learn(scan, "later"));
  scan.end = std::chrono::seconds(0);
  EXPECT_NO_THROW(memory_.learn(scan, "without anything to tell it by"));
  EXPECT_NO_THROW(memory_.learn(scan, "nor this one"));
}

TEST_F(PlaceMemoryTest, MakesUpLabelsThatAreFree) {
  EXPECT_EQ(learn(1, "").label, "place 1");
  EXPECT_EQ(learn(2, "place 3").label, "place 3");
  EXPECT_EQ(learn(3, "").label, "place 4");
  EXPECT_EQ(learn(4, "place 5").label, "place 5");
  EXPECT_EQ(learn(5, "place 6").label, "place 6");
  EXPECT_EQ(learn(6, "").label, "place 7");
}

TEST_F(PlaceMemoryTest, ALabelIsGivenOnce) {
  learn(1, "a");
  learn(2, "b");
  expectRefused(Reason::kLabelTaken, [&] { learn(3, "a"); });
  expectRefused(Reason::kLabelTaken, [&] { memory_.rename("a", "b"); });
  EXPECT_NO_THROW(memory_.rename("a", "a"));
  EXPECT_EQ(labels(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(PlaceMemoryTest, RefusesWhatIsNoLabel) {
  learn(1, "a");
  expectRefused(Reason::kInvalidLabel, [&] { learn(2, "a\nb"); });
  expectRefused(Reason::kInvalidLabel, [&] { learn(2, std::string(256, 'x')); });
  expectRefused(Reason::kInvalidLabel, [&] { memory_.rename("a", ""); });
  expectRefused(Reason::kInvalidLabel, [&] { memory_.rename("a", "\xff"); });
  EXPECT_EQ(labels(), std::vector<std::string>{"a"});
}

TEST_F(PlaceMemoryTest, RefusesPlacesItDoesNotKnow) {
  learn(1, "a");
  expectRefused(Reason::kUnknownPlace, [&] { memory_.rename("b", "c"); });
  expectRefused(Reason::kUnknownPlace, [&] { memory_.remove("b"); });
  expectRefused(Reason::kUnknownPlace, [&] { memory_.remove(""); });
  expectRefused(Reason::kUnknownPlace, [&] { memory_.grid(99); });
  EXPECT_FALSE(memory_.place(99));
}

TEST_F(PlaceMemoryTest, ARefusalDoesNotRepeatWhatIsNoText) {
  try {
    memory_.remove("\xff\xfe");
    FAIL() << "nothing was refused";
  } catch (const PlaceMemoryError& error) {
    EXPECT_EQ(std::string(error.what()).find('\xff'), std::string::npos);
  }
}

TEST_F(PlaceMemoryTest, ARemovedPlaceIsForgotten) {
  learn(1, "a");
  const Place removed = learn(2, "b");
  learn(3, "c");
  memory_.remove("b");
  EXPECT_EQ(labels(), (std::vector<std::string>{"a", "c"}));
  EXPECT_TRUE(links().empty());
  expectRefused(Reason::kUnknownPlace, [&] { memory_.grid(removed.id); });
  EXPECT_EQ(recognize(2).recognition.matches.size(), 2U);
  EXPECT_NE(recognize(2).recognition.verdict, Verdict::kRecognized);
}

TEST_F(PlaceMemoryTest, ARenamedPlaceIsRecognizedByItsNewLabel) {
  const Place place = learn(1, "a");
  memory_.rename("a", "b");
  const PlaceMemory::Answer answer = recognize(1);
  EXPECT_EQ(answer.labels, std::vector<std::string>{"b"});
  EXPECT_EQ(answer.recognition.matches.front().id, place.id);
}

TEST_F(PlaceMemoryTest, ClearingForgetsAllButTheIds) {
  learn(1, "a");
  const Place last = learn(2, "b");
  EXPECT_EQ(memory_.clear(), 2U);
  EXPECT_EQ(memory_.size(), 0U);
  EXPECT_EQ(previous(), "");
  EXPECT_TRUE(recognize(1).recognition.matches.empty());
  EXPECT_GT(learn(1, "a").id, last.id);
  EXPECT_EQ(memory_.clear(), 1U);
}

TEST_F(PlaceMemoryTest, LinksANewPlaceToTheOneBeforeIt) {
  learn(1, "a");
  learn(2, "b");
  learn(3, "c");
  EXPECT_EQ(links(), (std::vector<Ends>{{1, 2}, {2, 3}}));
  EXPECT_EQ(previous(), "c");
}

TEST_F(PlaceMemoryTest, LinksANewPlaceToTheOneRecognizedLast) {
  learn(1, "a");
  learn(2, "b");
  ASSERT_EQ(recognize(1).recognition.verdict, Verdict::kRecognized);
  EXPECT_EQ(previous(), "a");
  learn(3, "c");
  EXPECT_EQ(links(), (std::vector<Ends>{{1, 2}, {1, 3}}));
}

TEST_F(PlaceMemoryTest, WhatIsNotRecognizedLinksNothing) {
  learn(1, "a");
  learn(2, "b");
  ASSERT_NE(recognize(50).recognition.verdict, Verdict::kRecognized);
  EXPECT_EQ(previous(), "b");
}

TEST_F(PlaceMemoryTest, LinksToNoneAfterThePreviousPlaceWasForgottenOrRemoved) {
  learn(1, "a");
  memory_.forgetWhereabouts();
  learn(2, "b");
  memory_.remove("b");
  learn(3, "c");
  EXPECT_TRUE(links().empty());
}

TEST_F(PlaceMemoryTest, RefusesAHeadingWindowOutOfRange) {
  learn(1, "a");
  const Scan scan = makeRandomScan(1);
  EXPECT_THROW(memory_.recognize(scan, -0.1), std::invalid_argument);
  EXPECT_THROW(memory_.recognize(scan, 4.0), std::invalid_argument);
  EXPECT_THROW(memory_.recognize(scan, std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
}

TEST_F(PlaceMemoryTest, AScanWithoutAnEchoIsLearnedOnlyByForce) {
  Scan silent;
  try {
    memory_.learn(silent, "open");
    ADD_FAILURE() << "it was learned";
  } catch (const PlaceMemoryError& error) {
    EXPECT_EQ(error.reason(), PlaceMemoryError::Reason::kNoEcho);
  }
  EXPECT_TRUE(labels().empty());
  EXPECT_EQ(memory_.learn(silent, "open", true).place.label, "open");
  EXPECT_EQ(memory_.recognize(silent, kHeadingWindow).recognition.verdict, Verdict::kUnknown);
}

class StoredPlaceMemoryTest : public testing::Test {
 protected:
  PlaceMemoryOptions options() const {
    PlaceMemoryOptions options;
    options.store_path = folder_.file("places.db");
    return options;
  }

  const TemporaryFolder folder_;
};

TEST_F(StoredPlaceMemoryTest, KnowsItsPlacesWhenItComesBack) {
  {
    PlaceMemory memory(options());
    memory.learn(makeRandomScan(1), "a");
    memory.learn(makeRandomScan(2), "b");
  }
  PlaceMemory memory(options());
  EXPECT_EQ(memory.size(), 2U);
  EXPECT_EQ(memory.map().links.size(), 1U);
  EXPECT_EQ(memory.recognize(makeRandomScan(2), kHeadingWindow).labels.front(), "b");
}

TEST_F(StoredPlaceMemoryTest, DoesNotLinkAcrossABreak) {
  PlaceMemory(options()).learn(makeRandomScan(1), "a");
  PlaceMemory memory(options());
  EXPECT_EQ(memory.whereabouts().previous, kNoPlace);
  memory.learn(makeRandomScan(2), "b");
  EXPECT_TRUE(memory.map().links.empty());
}

TEST_F(StoredPlaceMemoryTest, RefusesAStoreOfOtherCells) {
  PlaceMemory(options()).learn(makeRandomScan(1), "a");
  PlaceMemoryOptions other = options();
  other.cell_size = 0.2;
  EXPECT_THROW(PlaceMemory{other}, StoreError);
}

}  // namespace
}  // namespace place_memory::core
