#include "core/sensing/scan_echoes.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/random_room.h"
#include "core/sensing/sweep_builder.h"
#include "core/sensing/sweep_fixture.h"

namespace place_memory::core {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();

SonarReading reading(double yaw, double range) {
  return {{0.0, 0.0, yaw}, {0.4, 0.1, 50.0}, range};
}

Scan scanOf(const std::vector<double>& ranges) {
  std::vector<LocatedReading> readings;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    readings.push_back(located({}, 1, {0.0, 0.0, 0.5 * static_cast<double>(i)}, ranges[i]));
    readings.back().reading.spec.max_range = 50.0;
  }
  return makeScan(readings, {}, {}, SonarModel({}), {});
}

TEST(CountEchoes, CountsThoseWithinTheGridAlone) {
  const GridGeometry geometry{0.1};  // to 3.2 m
  EXPECT_EQ(countEchoes({}, geometry), 0U);
  EXPECT_EQ(countEchoes({reading(0.0, 3.1), reading(0.0, 3.3), reading(1.0, kNoEcho)}, geometry),
            1U);
  EXPECT_EQ(countEchoes({reading(kPi / 4.0, 4.4)}, geometry), 1U) << "corners reach further";
  EXPECT_EQ(countEchoes({reading(kPi / 4.0, 4.6)}, geometry), 0U);
}

TEST(MakeScan, KnowsHowManyEchoesLieInItsGrid) {
  EXPECT_EQ(scanOf({1.0, kNoEcho, 2.0, 40.0}).echoes, 2U);
  EXPECT_EQ(scanOf({kNoEcho}).echoes, 0U);
}

TEST(HoldsEcho, OnlyAnEchoInTheGridTellsOfAPlace) {
  EXPECT_TRUE(holdsEcho(scanOf({1.0, kNoEcho})));
  EXPECT_FALSE(holdsEcho(scanOf({kNoEcho, kNoEcho})));
  EXPECT_FALSE(holdsEcho(scanOf({40.0, 30.0}))) << "echoes beyond the rim";
  EXPECT_FALSE(holdsEcho(scanOf({4.6, 4.6})))
      << "what an echo right behind the rim leaves in the last cells is no echo in the grid";
}

TEST(HoldsEcho, OfAScanWithoutReadingsItsGridIsAsked) {
  Scan scan = RandomRoom(1).scanFrom({});
  scan.readings.clear();
  EXPECT_TRUE(holdsEcho(scan));
  EXPECT_FALSE(holdsEcho({}));
}

}  // namespace
}  // namespace place_memory::core
