#include "core/explore/surveyed_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "core/explore/heard_walls.h"

namespace place_memory::core {
namespace {

constexpr double kSilence = std::numeric_limits<double>::infinity();
const SonarSpec kSonar{0.436, 0.15, 4.572};

int evidenceAt(const SurveyedCells& survey, double x, double y) {
  const FusedCells& cells = survey.cells;
  const int column = static_cast<int>(std::floor((x - cells.left) / cells.resolution));
  const int row = static_cast<int>(std::floor((y - cells.bottom) / cells.resolution));
  if (column < 0 || row < 0 || column >= cells.columns || row >= cells.rows) return 0;
  return cells.evidence[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
                        static_cast<std::size_t>(column)];
}

TEST(HeardWalls, StandThoughThoseWhoLookAlongThemHearNothing) {
  HeardWalls walls(0.1);
  for (double x = 0.0; x < 2.0; x += 0.1) {
    walls.add({x, 0.0, 0.5 * kPi}, kSonar, 1.05);       // head on
    walls.add({x, 0.0, 0.25 * kPi}, kSonar, kSilence);  // aslant: mirrored away
    walls.add({x, 0.0, 0.75 * kPi}, kSonar, kSilence);
  }
  EXPECT_TRUE(walls.isWall(1.0, 1.05));
  EXPECT_FALSE(walls.isWall(1.0, 0.5));
}

TEST(HeardWalls, GoWhereTheyAreHeardNoMore) {
  HeardWalls walls(0.1);
  for (int i = 0; i < 3; ++i) walls.add({0.0, 0.0, 0.0}, kSonar, 1.05);
  EXPECT_TRUE(walls.isWall(1.05, 0.0));
  for (int i = 0; i < 4; ++i) walls.add({0.0, 0.0, 0.0}, kSonar, 2.2);
  EXPECT_FALSE(walls.isWall(1.05, 0.0));
}

TEST(HeardWalls, GoWhereTheRobotStands) {
  HeardWalls walls(0.1);
  for (int i = 0; i < 3; ++i) walls.add({0.0, 0.0, 0.0}, kSonar, 1.05);
  walls.clearAround(1.05, 0.0, 0.2);
  EXPECT_FALSE(walls.isWall(1.05, 0.0));
}

TEST(HeardWalls, LieOnBothSidesOfTheOrigin) {
  HeardWalls walls(0.1);
  for (int i = 0; i < 3; ++i) walls.add({-3.0, -2.0, -kPi}, kSonar, 1.05);
  EXPECT_TRUE(walls.isWall(-4.05, -2.0));
  EXPECT_FALSE(walls.isWall(4.05, 2.0));
}

class SurveyedMapTest : public testing::Test {
 protected:
  /// Drives along x, a wall 1 m to its left.
  void driveAlongTheWall(double from, double to) {
    for (double x = from; x <= to; x += 0.05) {
      map_.hear({x, 0.0, 0.0}, {{0.0, 0.0, 0.5 * kPi}, kSonar, 1.0});
      map_.hear({x, 0.0, 0.0}, {{0.0, 0.0, 0.0}, kSonar, kSilence});
    }
  }

  SurveyedMap map_{{0.1}, GridGeometry{}, SonarModelOptions{}};
};

TEST_F(SurveyedMapTest, KnowsWhatIsAheadBeforeAPlaceIsMade) {
  EXPECT_TRUE(map_.cells({}).cells.evidence.empty());
  driveAlongTheWall(0.0, 1.0);
  const SurveyedCells survey = map_.cells({});
  EXPECT_LT(evidenceAt(survey, 3.0, 0.0), -10);
  EXPECT_GT(evidenceAt(survey, 0.5, 1.0), 10);
  EXPECT_EQ(evidenceAt(survey, 0.5, 3.0), 0);
  EXPECT_GT(survey.trail.size(), 5U);
}

TEST_F(SurveyedMapTest, WhatWasHeardMovesWithThePlaceItHangsOn) {
  Place place;
  place.id = 1;
  place.map_from_place = {0.5, 0.0, 0.0};
  map_.add(place, std::make_shared<const EvidenceGrid>(GridGeometry{}));
  driveAlongTheWall(0.0, 8.0);
  EXPECT_EQ(evidenceAt(map_.cells({}), 0.5, 1.05), EvidenceGrid::kLimit);
  place.map_from_place = {0.5, 2.0, 0.0};
  map_.add(place, std::make_shared<const EvidenceGrid>(GridGeometry{}));
  const SurveyedCells moved = map_.cells({});
  EXPECT_EQ(evidenceAt(moved, 0.5, 3.05), EvidenceGrid::kLimit);
  EXPECT_NE(evidenceAt(moved, 0.5, 1.05), EvidenceGrid::kLimit);
  EXPECT_NEAR(moved.trail.front().y, 2.0, 1e-6);
}

TEST_F(SurveyedMapTest, WhatHangsOnAPlaceThatGoesStays) {
  Place place;
  place.id = 1;
  place.map_from_place = {0.5, 0.0, 0.0};
  map_.add(place, std::make_shared<const EvidenceGrid>(GridGeometry{}));
  driveAlongTheWall(0.0, 8.0);
  map_.cells({});
  map_.apply({0, std::chrono::nanoseconds(0), {PlaceRemoved{1}}});
  EXPECT_EQ(evidenceAt(map_.cells({}), 0.5, 1.05), EvidenceGrid::kLimit);
}

TEST_F(SurveyedMapTest, WhatItHeardBeforeOdometryBeganAnewIsNotAhead) {
  driveAlongTheWall(0.0, 1.0);
  map_.cells({});
  map_.restart();
  const SurveyedCells survey = map_.cells({});
  EXPECT_GE(evidenceAt(survey, 3.0, 0.0), 0);
}

}  // namespace
}  // namespace place_memory::core
