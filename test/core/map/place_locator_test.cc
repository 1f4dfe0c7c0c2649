#include "core/map/place_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace place_memory::core {
namespace {

TEST(PlaceLocator, FindsWhatASearchOfAllFinds) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-20.0, 20.0), radius(0.1, 6.0);
  PlaceLocator locator(1.5);
  std::map<PlaceId, Pose2d> all;
  for (PlaceId id = 1; id <= 400; ++id) {
    const Pose2d pose{coordinate(random), coordinate(random), 0.0};
    locator.put(id, pose);
    all[id] = pose;
  }
  for (PlaceId id = 1; id <= 400; id += 3) locator.erase(id), all.erase(id);
  for (PlaceId id = 2; id <= 400; id += 3) {
    const Pose2d pose{coordinate(random), coordinate(random), 0.0};
    locator.put(id, pose);
    all[id] = pose;
  }
  EXPECT_EQ(locator.size(), all.size());
  for (int question = 0; question < 100; ++question) {
    const Pose2d at{coordinate(random), coordinate(random), 0.0};
    const double reach = radius(random);
    std::multimap<double, PlaceId> expected;
    for (const auto& [id, pose] : all) {
      const double distance = std::hypot(pose.x - at.x, pose.y - at.y);
      if (distance <= reach) expected.emplace(distance, id);
    }
    const std::vector<PlaceLocator::Near> found = locator.near(at, reach);
    ASSERT_EQ(found.size(), expected.size());
    auto next = expected.begin();
    for (const PlaceLocator::Near& near : found) {
      EXPECT_EQ(near.id, next->second);
      EXPECT_DOUBLE_EQ(near.distance, next->first);
      ++next;
    }
  }
}

TEST(PlaceLocator, ErasingWhatIsNotThereChangesNothing) {
  PlaceLocator locator(1.0);
  locator.put(1, {0.0, 0.0, 0.0});
  locator.erase(2);
  EXPECT_EQ(locator.near({0.0, 0.0, 0.0}, 0.5).size(), 1U);
}

}  // namespace
}  // namespace place_memory::core
