#include "core/route/route_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>

#include "core/route/route_world.h"

namespace place_memory::core {
namespace {

using Status = RouteAnswer::Status;
using Ids = std::vector<PlaceId>;
using std::chrono::hours;

// Two ways from 1 to 4, by 2 and by 3, and an island of 5 and 6.
class RoutePlannerTest : public testing::Test {
 protected:
  RoutePlannerTest() {
    std::vector<MapEdit> edits;
    for (PlaceId id = 1; id <= 6; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
    edits.emplace_back(linkOf(1, 2, 10.0));
    edits.emplace_back(linkOf(2, 4, 10.0));
    edits.emplace_back(linkOf(1, 3, 12.0));
    edits.emplace_back(linkOf(3, 4, 12.0));
    edits.emplace_back(linkOf(5, 6, 5.0));
    world_.change(edits);
  }

  void fail(PlaceId from, PlaceId to, int times) {
    const PlaceLink& link = *world_.map().findLink(from, to);
    LinkDirection direction = from == link.first ? link.forward : link.backward;
    for (int i = 0; i < times; ++i) {
      direction = learned(direction, {from, to, {}, {}, false, ""}, 10.0, 86400.0);
    }
    world_.change({LinkLearned{from, to, direction}});
  }

  RouteWorld world_;
};

TEST_F(RoutePlannerTest, TakesTheQuickestWay) {
  const RouteAnswer answer = world_.plan(1, 4, true);
  ASSERT_EQ(answer.status, Status::kFound);
  EXPECT_EQ(answer.best.places, (Ids{1, 2, 4}));
  EXPECT_DOUBLE_EQ(answer.best.time, 20.0);
  EXPECT_NEAR(answer.best.cost, world_.cost(1, 2) + world_.cost(2, 4), 1e-9);
  EXPECT_NEAR(answer.expected_cost, answer.best.cost, 1e-9);
  EXPECT_LT(answer.best.odds, 1.0);
  ASSERT_TRUE(answer.second);
  EXPECT_EQ(answer.second->places, (Ids{1, 3, 4}));
  EXPECT_EQ(answer.shared_links, 0U);
}

TEST_F(RoutePlannerTest, GoesAroundWhatFailsThatWayOnlyAndComesBackWithTime) {
  fail(2, 4, 6);
  EXPECT_EQ(world_.plan(1, 4).best.places, (Ids{1, 3, 4}));
  EXPECT_EQ(world_.plan(4, 1).best.places, (Ids{4, 2, 1}));
  world_.setNow(hours(24 * 30));
  EXPECT_EQ(world_.plan(1, 4).best.places, (Ids{1, 2, 4}));
}

TEST_F(RoutePlannerTest, LeavesOutWhatIsAvoidedOrForbidden) {
  RouteRequest request;
  request.starts = {{1, 1.0}};
  request.goal = 4;
  request.avoided = {{2, 4}};
  EXPECT_EQ(world_.planner().plan(request, {}).best.places, (Ids{1, 3, 4}));
  request.avoided.emplace_back(3, 4);
  const RouteAnswer answer = world_.planner().plan(request, {});
  EXPECT_EQ(answer.status, Status::kNoRoute);
  EXPECT_NE(answer.reason.find("just found blocked"), std::string::npos);
  LinkDirection forbidden;
  forbidden.forbidden = true;
  world_.change({LinkLearned{2, 4, forbidden}, LinkLearned{3, 4, forbidden}});
  EXPECT_NE(world_.plan(1, 4).reason.find("forbidden"), std::string::npos);
  EXPECT_EQ(world_.plan(4, 1).status, Status::kFound);
}

TEST_F(RoutePlannerTest, CountsTolls) {
  LinkDirection dear;
  dear.time = 10.0;
  dear.toll = 100.0;
  world_.change({LinkLearned{1, 2, dear}});
  EXPECT_EQ(world_.plan(1, 4).best.places, (Ids{1, 3, 4}));
}

TEST_F(RoutePlannerTest, SaysThatAPlaceLiesOnAnIsland) {
  const RouteAnswer answer = world_.plan(1, 6);
  EXPECT_EQ(answer.status, Status::kNoRoute);
  EXPECT_NE(answer.reason.find("\"p6\" is, with 1 other places"), std::string::npos)
      << answer.reason;
  EXPECT_NE(answer.reason.find("\"p1\" is, with 3 other places"), std::string::npos);
  EXPECT_EQ(answer.stranded, 1.0);
}

TEST_F(RoutePlannerTest, PlacesThatAreNotThereAreAnswers) {
  EXPECT_EQ(world_.plan(1, 99).status, Status::kUnknownGoal);
  EXPECT_EQ(world_.plan(99, 1).status, Status::kUnknownStart);
  EXPECT_EQ(world_.planner().plan({{}, 1, {}, true}, {}).status, Status::kUnknownStart);
}

TEST_F(RoutePlannerTest, ARobotThatIsThereGoesNowhere) {
  const RouteAnswer answer = world_.plan(2, 2, true);
  EXPECT_EQ(answer.status, Status::kFound);
  EXPECT_EQ(answer.best.places, (Ids{2}));
  EXPECT_EQ(answer.best.cost, 0.0);
  EXPECT_FALSE(answer.second);
}

TEST_F(RoutePlannerTest, WeighsAllPlacesWhereTheRobotMayBe) {
  RouteRequest request;
  request.starts = {{5, 0.1}, {2, 0.3}, {1, 0.6}, {77, 0.5}};
  request.goal = 4;
  const RouteAnswer answer = world_.planner().plan(request, {});
  ASSERT_EQ(answer.status, Status::kFound);
  EXPECT_EQ(answer.best.places, (Ids{1, 2, 4}));
  EXPECT_NEAR(answer.stranded, 0.1, 1e-12);
  EXPECT_NEAR(answer.expected_cost, (0.6 * answer.best.cost + 0.3 * world_.cost(2, 4)) / 0.9, 1e-9);
}

TEST_F(RoutePlannerTest, FollowsWhatBecomesOfTheMap) {
  world_.change({PlaceRemoved{2}});
  EXPECT_EQ(world_.plan(1, 4).best.places, (Ids{1, 3, 4}));
  world_.change({LinkRemoved{1, 3}});
  EXPECT_EQ(world_.plan(1, 4).status, Status::kNoRoute);
  world_.change({placeAt(7, 0.0, 0.0), linkOf(1, 7, 1.0), linkOf(7, 4, 1.0)});
  EXPECT_EQ(world_.plan(1, 4).best.places, (Ids{1, 7, 4}));
  world_.change({MapCleared{}});
  EXPECT_EQ(world_.plan(1, 4).status, Status::kUnknownGoal);
}

TEST(RoutePlanner, RefusesOptionsOutOfRange) {
  const PlaceMap map;
  EXPECT_THROW(RoutePlanner(map, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(RoutePlanner(map, {1.0, -1.0}), std::invalid_argument);
}

// Against a search that goes over all links again and again, while the map changes.
TEST(RoutePlanner, FindsWhatANaiveSearchFinds) {
  std::mt19937 random(3);
  const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(1, most)(random); };
  for (int round = 0; round < 20; ++round) {
    RouteWorld world;
    std::vector<MapEdit> edits;
    constexpr int kPlaces = 25;
    for (PlaceId id = 1; id <= kPlaces; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
    world.change(edits);
    for (int step = 0; step < 60; ++step) {
      const PlaceId one = upTo(kPlaces), other = upTo(kPlaces);
      if (one != other) world.change({linkOf(one, other, upTo(30))});
      if (one != other && step % 3 == 0) {
        LinkDirection direction;
        direction.time = upTo(30);
        direction.blocked = upTo(8);
        direction.forbidden = step % 9 == 0;
        world.change({LinkLearned{one, other, direction}});
      }
      if (step < 20 || step % 4 != 0) continue;
      const PlaceId from = upTo(kPlaces), to = upTo(kPlaces);
      const RouteAnswer answer = world.plan(from, to);
      const double least = world.leastCost(from, to);
      EXPECT_EQ(answer.status == Status::kFound, std::isfinite(least));
      if (answer.status != Status::kFound) continue;
      EXPECT_NEAR(answer.best.cost, least, 1e-3);
      double cost = 0.0;
      for (std::size_t i = 1; i < answer.best.places.size(); ++i) {
        cost += world.cost(answer.best.places[i - 1], answer.best.places[i]);
      }
      EXPECT_NEAR(cost, least, 1e-3);
    }
  }
}

// Against all ways there are.
TEST(RoutePlanner, TheSecondRouteSharesTheFewestLinks) {
  std::mt19937 random(5);
  const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(1, most)(random); };
  for (int round = 0; round < 40; ++round) {
    constexpr int kPlaces = 7;
    RouteWorld world;
    std::vector<MapEdit> edits;
    for (PlaceId id = 1; id <= kPlaces; ++id) edits.emplace_back(placeAt(id, 0.0, 0.0));
    for (int i = 0; i < 9; ++i) {
      const PlaceId one = upTo(kPlaces), other = upTo(kPlaces);
      if (one != other) edits.emplace_back(linkOf(one, other, upTo(30)));
    }
    world.change(edits);
    const RouteAnswer answer = world.plan(1, kPlaces, true);
    if (answer.status != Status::kFound) continue;
    std::set<std::pair<PlaceId, PlaceId>> links;
    for (std::size_t i = 1; i < answer.best.places.size(); ++i) {
      links.insert(std::minmax(answer.best.places[i - 1], answer.best.places[i]));
    }
    std::pair<std::size_t, double> least{99, 0.0};
    Ids way{1};
    const std::function<void(std::size_t, double)> walk = [&](std::size_t shared, double cost) {
      if (way.back() == kPlaces) {
        if (way != answer.best.places) least = std::min(least, {shared, cost});
        return;
      }
      for (const PlaceId next : world.map().neighbours(way.back())) {
        if (std::find(way.begin(), way.end(), next) != way.end()) continue;
        const PlaceId at = way.back();
        way.push_back(next);
        walk(shared + links.count(std::minmax(at, next)), cost + world.cost(at, next));
        way.pop_back();
      }
    };
    walk(0, 0.0);
    EXPECT_EQ(answer.second.has_value(), least.first < 99);
    if (!answer.second) continue;
    EXPECT_EQ(answer.shared_links, least.first);
    EXPECT_NEAR(answer.second->cost, least.second, 1e-3);
  }
}

}  // namespace
}  // namespace place_memory::core
