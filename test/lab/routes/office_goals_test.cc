#include "routes/office_goals.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/scene/world_loader.h"

namespace place_memory::routes {
namespace {

TEST(OfficeGoals, AreReachedUnlessNoWayIsLeft) {
  constexpr int kGoals = 100;
  const sim::World office =
      sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/office.yaml");
  const GoalCounts counts = driveGoals(office, kGoals, 1, 0.0);
  EXPECT_EQ(counts.reached + counts.no_route, kGoals) << counts.messages;
  EXPECT_EQ(counts.false_reached, 0);
  EXPECT_EQ(counts.false_no_route, 0);
  EXPECT_EQ(counts.false_blocked, 0);
  EXPECT_GT(counts.blocked, 10U);
  EXPECT_GT(counts.closed_ahead, kGoals / 4);
  EXPECT_GT(counts.reached, kGoals / 2);
}

}  // namespace
}  // namespace place_memory::routes
