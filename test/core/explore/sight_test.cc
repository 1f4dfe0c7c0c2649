#include "core/explore/sight.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/explore/floor_plan.h"

namespace place_memory::core {
namespace {

// Half a metre a character: a corridor, a wall, and behind it a room; to the east all is unknown.
const std::vector<std::string> kPlan{
    "##############", "#............#", "##############", "#.......      ", "##############",
};
constexpr double kCorridor = 0.75;  // y of its middle [m]

class SightTest : public testing::Test {
 protected:
  bool sees(double x, double y) const {
    const FreeSpace space({}, floorPlan(kPlan, 5), trail_.front(), {});
    return inSight(space, trail_, options_)[space.cellAt(x, y).value()] != 0;
  }

  std::vector<Pose2d> trail_{{1.05, kCorridor, 0.0}};
  SightOptions options_;
};

TEST_F(SightTest, NothingIsInSightWithoutAWay) {
  const FreeSpace space({}, floorPlan(kPlan, 5), {1.0, kCorridor, 0.0}, {});
  for (const std::uint8_t seen : inSight(space, {}, options_)) EXPECT_EQ(seen, 0);
}

TEST_F(SightTest, ItEndsAtTheReach) {
  options_.reach = 2.0;
  EXPECT_TRUE(sees(2.95, kCorridor));
  EXPECT_FALSE(sees(3.25, kCorridor));
}

TEST_F(SightTest, ItEndsAtWalls) { EXPECT_FALSE(sees(1.0, 1.75)); }

TEST_F(SightTest, ItLeadsALittleIntoTheUnknown) {
  trail_ = {{3.55, kCorridor, 0.0}};
  EXPECT_TRUE(sees(4.05 + 0.5 * options_.beyond, kCorridor));
  EXPECT_FALSE(sees(4.25 + options_.beyond, kCorridor));
}

TEST_F(SightTest, EverySpotOfTheWayLooksAbout) {
  options_.reach = 1.0;
  EXPECT_FALSE(sees(3.35, kCorridor));
  trail_.push_back({3.05, kCorridor, 0.0});
  EXPECT_TRUE(sees(3.35, kCorridor));
}

}  // namespace
}  // namespace place_memory::core
