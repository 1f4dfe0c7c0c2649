#include <gtest/gtest.h>

#include <algorithm>

#include "core/memory/place_memory_fixture.h"
#include "core/temporary_folder.h"

// Maps that come from the stores of other robots, or go there.
namespace place_memory::core {
namespace {

using Labels = std::vector<std::string>;

/// This robot has been where scans 1 to 4 were taken, two metres apart; another one at 2 to 6, in a
/// frame of its own that lies turned by a quarter and 20 m off.
class MapTravelTest : public PlaceMemoryTest {
 protected:
  static constexpr double kWay = 2.0;

  static Scan scanAt(unsigned seed, const Pose2d& odom_from_scan) {
    Scan scan = makeRandomScan(seed);
    scan.odom_from_scan = odom_from_scan;
    return scan;
  }

  static Pose2d ours(unsigned seed) { return {kWay * seed, 0.0, 0.0}; }
  static Pose2d theirs(unsigned seed) { return Pose2d{20.0, 0.0, kPi / 2.0} * ours(seed); }

  std::string otherStore(unsigned first, unsigned last, const std::string& prefix) const {
    PlaceMemoryOptions kept = options();
    kept.store_path = folder_.file("other.db");
    PlaceMemory other(kept);
    for (unsigned seed = first; seed <= last; ++seed) {
      other.learn(scanAt(seed, theirs(seed)), prefix + std::to_string(seed));
    }
    return kept.store_path;
  }

  void learnOurs() {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      memory_.learn(scanAt(seed, ours(seed)), "our " + std::to_string(seed));
    }
  }

  Place place(const std::string& label) const {
    for (const Place& place : memory_.map().places) {
      if (place.label == label) return place;
    }
    ADD_FAILURE() << "no place " << label;
    return {};
  }

  static PlaceMemoryOptions options() {
    PlaceMemoryOptions options = PlaceMemoryTest::options();
    options.recognizer.heading_window = kHeadingWindow;
    return options;
  }

  static void expectNear(const Pose2d& expected, const Pose2d& pose) {
    EXPECT_NEAR(expected.x, pose.x, 0.1);
    EXPECT_NEAR(expected.y, pose.y, 0.1);
    EXPECT_NEAR(wrapAngle(expected.yaw - pose.yaw), 0.0, 0.05);
  }

  const TemporaryFolder folder_;
  PlaceMemory memory_{options()};
};

TEST_F(MapTravelTest, ASavedMapIsLoadedByAnotherRobot) {
  learnOurs();
  const std::string path = folder_.file("saved.db");
  memory_.save(path);
  PlaceMemory robot(options());
  robot.learn(makeRandomScan(9), "gone");
  EXPECT_EQ(robot.load(path), 4U);
  const MapSnapshot map = robot.map();
  ASSERT_EQ(map.places.size(), 4U);
  EXPECT_EQ(map.links.size(), 3U);
  EXPECT_EQ(map.places.front().label, "our 1");
  EXPECT_EQ(map.places.front().identity, place("our 1").identity);
  EXPECT_GT(map.places.front().id, 1);  // ids are never given twice
  EXPECT_FALSE(robot.whereabouts().map_from_odom);
  const auto answer = robot.recognize(makeRandomScan(3), kHeadingWindow);
  EXPECT_EQ(answer.labels.front(), "our 3");
  robot.undo();
  EXPECT_EQ(robot.map().places.front().label, "gone");
}

TEST_F(MapTravelTest, SessionsAreCountedOneByOneHoweverOftenAMapIsSavedAndLoaded) {
  learnOurs();
  const std::string path = folder_.file("saved.db");
  for (SessionId loads = 1; loads <= 40; ++loads) {
    memory_.save(path);
    EXPECT_EQ(memory_.load(path), 4U);
    const SessionId session = place("our 1").session;
    EXPECT_LE(session, 1 + loads);
    EXPECT_EQ(place("our 4").session, session);
  }
}

TEST_F(MapTravelTest, WhatIsNoStoreIsRefused) {
  for (const std::string& path : {folder_.file("none.db"), folder_.path().string()}) {
    for (const bool merges : {false, true}) {
      try {
        if (merges) {
          memory_.merge(path);
        } else {
          memory_.load(path);
        }
        ADD_FAILURE() << path << " was taken";
      } catch (const PlaceMemoryError& error) {
        EXPECT_EQ(error.reason(), PlaceMemoryError::Reason::kOtherStore);
      }
    }
  }
}

TEST_F(MapTravelTest, AFrameIsFoundByThePlacesThatBothHaveSeen) {
  learnOurs();
  const MergeReport report = memory_.merge(otherStore(2, 6, "their "));
  EXPECT_EQ(report.joined, 1U);
  EXPECT_EQ(report.apart, 0U);
  EXPECT_EQ(report.known, 3U);
  EXPECT_EQ(report.added, 2U);
  EXPECT_TRUE(report.collisions.empty());
  EXPECT_EQ(memory_.size(), 6U);
  const Place added = place("their 6");
  EXPECT_EQ(added.session, kFirstSession);
  expectNear(ours(6), added.map_from_place);
  // Their link from 4 to 5 leads from our 4 now.
  const MapSnapshot map = memory_.map();
  const PlaceId four = place("our 4").id;
  const PlaceId five = place("their 5").id;
  const auto link =
      std::find_if(map.links.begin(), map.links.end(), [&](const PlaceLink& candidate) {
        return candidate.first == four && candidate.second == five;
      });
  ASSERT_NE(link, map.links.end());
  EXPECT_NEAR(link->first_from_second.x, kWay, 0.1);
}

TEST_F(MapTravelTest, WhatWasMergedIsKnownTheSecondTime) {
  learnOurs();
  const std::string path = otherStore(2, 6, "their ");
  memory_.merge(path);
  const MergeReport again = memory_.merge(path);
  EXPECT_EQ(again.added, 0U);
  EXPECT_EQ(again.known, 5U);
  EXPECT_EQ(memory_.size(), 6U);
}

TEST_F(MapTravelTest, WhereNothingIsRecognizedTheSessionStaysApartUntilSomethingIs) {
  learnOurs();
  const MergeReport report = memory_.merge(otherStore(11, 13, "their "));
  EXPECT_EQ(report.added, 3U);
  EXPECT_EQ(report.joined, 0U);
  EXPECT_EQ(report.apart, 1U);
  EXPECT_GT(place("their 11").session, kFirstSession);
  expectNear(theirs(11), place("their 11").map_from_place);
}

TEST_F(MapTravelTest, LabelsThatAreTakenAreChangedAndReported) {
  learnOurs();
  const MergeReport report = memory_.merge(otherStore(11, 12, "our "));
  EXPECT_TRUE(report.collisions.empty());
  memory_.rename("our 11", "our 21");
  memory_.undo(2);
  memory_.rename("our 1", "our 12");
  const MergeReport second = memory_.merge(folder_.file("other.db"));
  ASSERT_EQ(second.collisions.size(), 1U);
  EXPECT_EQ(second.collisions.front().label, "our 12");
  EXPECT_EQ(second.collisions.front().new_label, "our 12 (2)");
  EXPECT_EQ(place("our 12 (2)").learned, makeRandomScan(12).end);
}

TEST_F(MapTravelTest, AMergeIsUndoneAsOneChange) {
  learnOurs();
  const MapSnapshot before = memory_.map();
  memory_.merge(otherStore(2, 6, "their "));
  EXPECT_NE(memory_.undo().front().words.find("merged 2 places"), std::string::npos);
  EXPECT_TRUE(memory_.map().places == before.places);
  EXPECT_TRUE(memory_.map().links == before.links);
}

}  // namespace
}  // namespace place_memory::core
