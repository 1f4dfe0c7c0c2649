#include "core/route/route_reach.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/route/route_world.h"

namespace place_memory::core {
namespace {

class RouteReach : public testing::TestWithParam<unsigned> {};

TEST_P(RouteReach, NamesEveryPlaceThatIsNearEnoughAndNoOther) {
  std::mt19937 random(GetParam());
  RouteWorld world;
  std::vector<MapEdit> edits;
  constexpr PlaceId kPlaces = 30;
  for (PlaceId id = 1; id <= kPlaces; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
  std::map<std::pair<PlaceId, PlaceId>, bool> linked;
  for (int i = 0; i < 40; ++i) {
    const auto one = static_cast<PlaceId>(1 + random() % kPlaces);
    const auto other = static_cast<PlaceId>(1 + random() % kPlaces);
    if (one == other || linked[std::minmax(one, other)]) continue;
    linked[std::minmax(one, other)] = true;
    LinkAdded link = linkOf(one, other, 1.0 + static_cast<double>(random() % 9));
    link.link.forward.forbidden = random() % 8 == 0;
    edits.emplace_back(link);
  }
  world.change(edits);

  RouteGraph graph{LinkLearningOptions()};
  graph.build(world.map());
  graph.refresh(world.map(), {});
  constexpr double kMost = 15.0;
  std::map<PlaceId, ReachedPlace> reached;
  double before = 0.0;
  for (const ReachedPlace& place : reachedFrom(graph, 1, kMost)) {
    EXPECT_GE(place.time, before);
    before = place.time;
    // Its way goes on from one that came earlier.
    EXPECT_EQ(place.before == kNoPlace, place.place == 1);
    if (place.before != kNoPlace) {
      ASSERT_EQ(reached.count(place.before), 1U);
      EXPECT_NEAR(place.time, reached[place.before].time + world.cost(place.before, place.place),
                  1e-4);
    }
    EXPECT_TRUE(reached.emplace(place.place, place).second);
  }
  for (PlaceId id = 1; id <= kPlaces; ++id) {
    const double least = world.leastCost(1, id);
    if (std::abs(least - kMost) < 1e-3) continue;
    EXPECT_EQ(reached.count(id) == 1, least < kMost) << id;
    if (reached.count(id) == 0) continue;
    EXPECT_NEAR(reached[id].time, least, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RouteReach, testing::Range(1U, 9U));

TEST(RouteReachOfNothing, APlaceThatIsNotThereReachesNone) {
  RouteWorld world;
  world.change({placeAt(1, 0.0, 0.0)});
  RouteGraph graph{LinkLearningOptions()};
  graph.build(world.map());
  EXPECT_TRUE(reachedFrom(graph, 7, 100.0).empty());
  EXPECT_EQ(reachedFrom(graph, 1, 100.0).size(), 1U);
}

}  // namespace
}  // namespace place_memory::core
