// Two hundred goals in the simulated office, while ways are barred and cleared: planner, links that
// learn, the goal's run and the leg driver together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/drive/goal_run.h"
#include "core/drive/leg_driver.h"
#include "core/map/link_odds.h"
#include "core/route/route_planner.h"
#include "sim/robot/simulation.h"
#include "sim/scene/world_loader.h"

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;
using Ends = std::pair<PlaceId, PlaceId>;

constexpr double kStep = 0.1;  // [s]
constexpr double kHalfLife = 3600.0;
constexpr int kGoals = 200;

class Office {
 public:
  explicit Office(unsigned seed)
      : random_(seed),
        world_(sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/office.yaml")),
        map_(mapOf(world_)),
        planner_(map_, {kHalfLife, 0.3}) {
    putRobot({world_.places[0].position.x, world_.places[0].position.y, 0.0});
  }

  struct Counts {
    int reached = 0;
    int no_route = 0;
    int others = 0;
    int false_reached = 0;
    int false_blocked = 0;
    std::size_t blocked = 0;
    std::string messages;
  };

  void goTo(PlaceId goal, Counts& counts) {
    GoalRun::Hooks hooks;
    hooks.plan = [&](PlaceId from, const GoalRun::Avoided& avoided) {
      return plan(from == kNoPlace ? nearest() : from, goal, avoided);
    };
    hooks.report = [&](const Traversal& traversal) {
      if (!traversal.succeeded && barred_.count(std::minmax(traversal.from, traversal.to)) == 0) {
        ++counts.false_blocked;
      }
      report(traversal);
    };
    GoalRun run(hooks, std::nullopt, "simulation");
    run.begin(pose(), now());
    while (!run.isOver()) driveLeg(run);
    counts.blocked += run.tried().size();
    const Place& place = *map_.find(goal);
    const double off =
        std::hypot(pose().x - place.map_from_place.x, pose().y - place.map_from_place.y);
    if (run.outcome() == GoalRun::Outcome::kReached) {
      ++counts.reached;
      if (off > 0.5) ++counts.false_reached;
    } else if (run.outcome() == GoalRun::Outcome::kNoRoute) {
      ++counts.no_route;
    } else {
      ++counts.others;
      counts.messages += run.message() + '\n';
    }
  }

  /// Bars a way or two, and clears those that were barred before.
  void change() {
    const std::vector<PlaceLink> links = map_.links();
    barred_.clear();
    const std::size_t count = random_() % 4;
    for (std::size_t i = 0; i < count; ++i) {
      const PlaceLink& link = links[random_() % links.size()];
      const Pose2d box = boxOn({link.first, link.second}).pose;
      if (std::hypot(pose().x - box.x, pose().y - box.y) > 1.2) {
        barred_.insert({link.first, link.second});
      }
    }
    putRobot(pose());
  }

  PlaceId anyPlace() { return map_.places()[random_() % (map_.size() - 1)].id; }

 private:
  static PlaceMap mapOf(const sim::World& world) {
    std::vector<Place> places;
    for (const sim::Place& at : world.places) {
      Place place;
      place.id = static_cast<PlaceId>(places.size() + 1);
      place.label = at.label;
      place.map_from_place = {at.position.x, at.position.y, 0.0};
      places.push_back(place);
    }
    std::vector<PlaceLink> links;
    const auto neighbours = sim::placeNeighbours(world);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      for (const std::size_t j : neighbours[i]) {
        if (j <= i) continue;
        PlaceLink link;
        link.first = places[i].id;
        link.second = places[j].id;
        link.first_from_second = places[i].map_from_place.inverse() * places[j].map_from_place;
        links.push_back(link);
      }
    }
    return {places, links, 0, nanoseconds(0)};
  }

  // From wall to wall of a corridor.
  sim::Box boxOn(const Ends& link) const {
    const Pose2d one = map_.find(link.first)->map_from_place;
    const Pose2d other = map_.find(link.second)->map_from_place;
    const double yaw = std::atan2(other.y - one.y, other.x - one.x);
    return {{0.5 * (one.x + other.x), 0.5 * (one.y + other.y), yaw}, 0.2, 2.3, {}};
  }

  void putRobot(const Pose2d& pose) {
    sim::World world = world_;
    for (const Ends& link : barred_) world.boxes.push_back(boxOn(link));
    sim::SimulationOptions options;
    options.drift = {0.0, 0.0, 0.0};
    simulation_ = std::make_unique<sim::Simulation>(std::move(world), pose, options);
  }

  Pose2d pose() const { return simulation_->base().truth(); }
  nanoseconds now() const { return nanoseconds(std::llround(1e9 * time_)); }

  PlaceId nearest() const {
    const auto distance = [&](const Place& place) {
      return std::hypot(place.map_from_place.x - pose().x, place.map_from_place.y - pose().y);
    };
    return std::min_element(map_.places().begin(), map_.places().end(),
                            [&](const Place& one, const Place& other) {
                              return distance(one) < distance(other);
                            })
        ->id;
  }

  RoutePlan plan(PlaceId from, PlaceId goal, const GoalRun::Avoided& avoided) {
    RouteRequest request;
    request.starts = {{from, 1.0}};
    request.goal = goal;
    request.avoided = avoided;
    RoutePlan plan;
    plan.answer = planner_.plan(request, now());
    for (const PlaceId id : plan.answer.best.places) plan.best.push_back(*map_.find(id));
    return plan;
  }

  void report(const Traversal& traversal) {
    const PlaceLink& link = *map_.findLink(traversal.from, traversal.to);
    const LinkDirection& before = traversal.from == link.first ? link.forward : link.backward;
    const MapChange change{map_.version() + 1,
                           traversal.end,
                           {LinkLearned{traversal.from, traversal.to,
                                        learned(before, traversal, 10.0, kHalfLife), traversal}}};
    map_.apply(change);
    planner_.follow(change);
  }

  void driveLeg(GoalRun& run) {
    LegDriver driver({}, run.leg()->target);
    EchoRing echoes(std::chrono::milliseconds(500));
    while (!driver.isOver()) {
      const std::vector<double> ranges = simulation_->fire();
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        echoes.hear(static_cast<SensorId>(i), now(),
                    sim::sensorPose(simulation_->robot().ring, static_cast<int>(i)), ranges[i]);
      }
      const Velocity velocity = driver.update(now(), pose(), echoes);
      simulation_->step(kStep, velocity.forward, velocity.turn);
      time_ += kStep;
    }
    if (driver.state() == LegDriver::State::kArrived) {
      run.arrived(now());
    } else {
      run.blocked(driver.why(), now());
    }
  }

  std::mt19937 random_;
  sim::World world_;
  PlaceMap map_;
  RoutePlanner planner_;
  std::set<Ends> barred_;
  std::unique_ptr<sim::Simulation> simulation_;
  double time_ = 1.0;
};

TEST(GoalsInAnOffice, AreReachedUnlessNoWayIsLeft) {
  Office office(1);
  Office::Counts counts;
  for (int i = 0; i < kGoals; ++i) {
    office.change();
    office.goTo(office.anyPlace(), counts);
  }
  EXPECT_EQ(counts.reached + counts.no_route, kGoals) << counts.messages;
  EXPECT_EQ(counts.false_reached, 0);
  EXPECT_EQ(counts.false_blocked, 0);
  EXPECT_GT(counts.blocked, 20U);
  EXPECT_GT(counts.reached, kGoals * 3 / 4);
  RecordProperty("blocked", static_cast<int>(counts.blocked));
  RecordProperty("no_route", counts.no_route);
}

}  // namespace
}  // namespace place_memory::core
