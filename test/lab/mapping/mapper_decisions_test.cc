// What the mapper says of each scan, and of the wheels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "mapping/mapping_run.h"
#include "mapping/mapping_worlds.h"
#include "trials/simulated_drive.h"

namespace place_memory::mapping {
namespace {

using core::ScanDecision;

sim::World office() {
  return mappingWorld("office", 0, std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds");
}

trials::DriveRecipe recipe(double way) {
  trials::DriveRecipe recipe;
  recipe.way = way;
  recipe.changes = false;
  return recipe;
}

TEST(MapperDecisions, EachScanHasItsReasonAndEachPlaceTheScanThatMadeIt) {
  core::Mapper mapper(mapperOptions());
  Truth truth;
  DrivePart part;
  part.compass = false;
  const MappingRun run =
      drive(mapper, trials::simulateDrive(office(), {}, recipe(120.0), 3), part, truth);
  std::map<std::chrono::nanoseconds, ScanDecision> words;
  for (const DecisionRecord& record : run.decisions) {
    EXPECT_FALSE(record.decision.reason.empty());
    words[record.decision.stamp] = record.decision;
  }
  ASSERT_FALSE(mapper.places().empty());
  for (const core::MappedPlace& place : mapper.places()) {
    ASSERT_TRUE(words.count(place.stamp));
    EXPECT_EQ(words[place.stamp].kind, ScanDecision::Kind::kNewPlace) << place.id;
    EXPECT_EQ(words[place.stamp].place, place.id);
  }
}

TEST(MapperDecisions, ARobotTooFastForItsSensorsIsToldSo) {
  trials::DriveRecipe fast = recipe(60.0);
  fast.speed = 1.5;
  fast.sonars = {0, 4, 8, 12};
  core::Mapper mapper(mapperOptions());
  Truth truth;
  const MappingRun run = drive(mapper, trials::simulateDrive(office(), {}, fast, 4), {}, truth);
  // Where it turns on the spot there are readings enough.
  const auto told =
      std::count_if(run.decisions.begin(), run.decisions.end(), [](const DecisionRecord& record) {
        return record.decision.reason.find("too fast") != std::string::npos;
      });
  EXPECT_GT(2 * static_cast<std::size_t>(told), run.decisions.size());
}

TEST(MapperDecisions, LoopsShowHowTheWheelsBend) {
  trials::DriveRecipe bent = recipe(150.0);
  bent.scale_sigma = bent.turn_factor_sigma = 0.0;
  bent.bend_sigma = 1.2 * core::kPi / 180.0;
  const trials::Drive moments = trials::simulateDrive(office(), {}, bent, 6);
  double measured = 0.0, turned = 0.0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    measured += core::wrapAngle(moments[i].odom.yaw - moments[i - 1].odom.yaw);
    turned += core::wrapAngle(moments[i].truth->yaw - moments[i - 1].truth->yaw);
  }
  core::Mapper mapper(mapperOptions());
  Truth truth;
  DrivePart part;
  part.compass = false;
  const MappingRun run = drive(mapper, moments, part, truth);
  const double bend = (turned - measured) / run.way();
  const double sigma = mapper.odometryErrorSigmas().bend;
  EXPECT_GT(sigma, 0.0);
  EXPECT_LT(sigma, 0.5 * core::kBendSigma);
  EXPECT_LT(std::abs(mapper.odometryErrors().bend - bend), 4.0 * sigma);
}

}  // namespace
}  // namespace place_memory::mapping
