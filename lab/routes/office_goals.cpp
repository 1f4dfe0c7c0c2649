#include "routes/office_goals.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/drive/goal_run.h"
#include "core/drive/leg_driver.h"
#include "core/map/link_odds.h"
#include "core/route/route_planner.h"
#include "sim/robot/simulation.h"
#include "sim/scene/world_loader.h"

namespace place_memory::routes {
namespace {

using core::PlaceId;
using core::PlaceLink;
using core::Pose2d;
using std::chrono::nanoseconds;
using Ends = std::pair<PlaceId, PlaceId>;

constexpr double kStep = 0.1;         // [s]
constexpr double kHalfLife = 3600.0;  // of evidence [s]
constexpr double kSpeed = 0.3;        // [m/s]
constexpr double kRoomToBar = 1.2;    // nothing closes nearer to the robot [m]
constexpr double kBarLength = 2.3;    // from wall to wall of a corridor [m]
constexpr double kFar = 1e9;          // [m]
constexpr double kAstrayTurn = 0.2;   // for each metre that it is astray [rad/m]

core::PlaceMap mapOf(const sim::World& world) {
  std::vector<core::Place> places;
  for (const sim::Place& at : world.places) {
    core::Place place;
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

class Building {
 public:
  Building(const sim::World& world, std::uint64_t seed, double astray)
      : random_(seed),
        astray_most_(astray),
        world_(world),
        map_(mapOf(world_)),
        planner_(map_, {kHalfLife, kSpeed}) {
    putRobot({world_.places[0].position.x, world_.places[0].position.y, 0.0});
  }

  void goTo(PlaceId goal, GoalCounts& counts) {
    core::GoalRun::Hooks hooks;
    hooks.plan = [&](const core::GoalRun::Wish& wish) {
      return plan(wish.from == core::kNoPlace ? nearest(believed(), wish.unreachable) : wish.from,
                  goal, wish.avoided, counts);
    };
    hooks.report = [&](const core::Traversal& traversal) {
      const bool is_barred = barred_.count(std::minmax(traversal.from, traversal.to)) == 1;
      if (!traversal.succeeded && !is_barred) ++counts.false_blocked;
      report(traversal);
    };
    core::GoalRun run(hooks, std::nullopt, "simulation");
    goAstray();
    run.begin(believed(), now());
    close_at_ = way_ + std::uniform_real_distribution<double>(0.5, 8.0)(random_);
    while (!run.isOver()) driveLeg(run, counts);
    close_at_.reset();
    count(run, goal, counts);
    counts.way = way_;
  }

  /// Bars up to so many ways; those that were barred before are cleared.
  void reopen(std::size_t most) {
    barred_.clear();
    close(random_() % (most + 1));
  }

  PlaceId anyPlace() { return map_.places()[random_() % map_.size()].id; }

 private:
  bool close(std::size_t count) {
    const std::size_t before = barred_.size();
    const std::vector<PlaceLink> links = map_.links();
    for (std::size_t i = 0; i < count; ++i) {
      const PlaceLink& link = links[random_() % links.size()];
      const Pose2d box = boxOn({link.first, link.second}).pose;
      if (std::hypot(pose().x - box.x, pose().y - box.y) > kRoomToBar) {
        barred_.insert({link.first, link.second});
      }
    }
    putRobot(pose());
    return barred_.size() > before;
  }

  void count(const core::GoalRun& run, PlaceId goal, GoalCounts& counts) const {
    using Outcome = core::GoalRun::Outcome;
    counts.blocked += run.tried().size();
    const Pose2d& there = map_.find(goal)->map_from_place;
    switch (run.outcome()) {
      case Outcome::kReached:
        ++counts.reached;
        if (std::hypot(pose().x - there.x, pose().y - there.y) > 0.5) ++counts.false_reached;
        return;
      case Outcome::kNoRoute:
        ++counts.no_route;
        if (isReachable(nearest(pose(), {}), goal)) ++counts.false_no_route;
        return;
      case Outcome::kBlocked:
        ++counts.stuck;
        break;
      default:
        ++counts.others;
        break;
    }
    counts.messages += run.message() + '\n';
  }

  bool isReachable(PlaceId from, PlaceId to) const {
    std::set<PlaceId> seen{from};
    std::vector<PlaceId> next{from};
    while (!next.empty()) {
      const PlaceId at = next.back();
      next.pop_back();
      for (const PlaceId neighbour : map_.neighbours(at)) {
        if (barred_.count(std::minmax(at, neighbour)) == 0 && seen.insert(neighbour).second) {
          next.push_back(neighbour);
        }
      }
    }
    return seen.count(to) == 1;
  }

  sim::Box boxOn(const Ends& link) const {
    const Pose2d one = map_.find(link.first)->map_from_place;
    const Pose2d other = map_.find(link.second)->map_from_place;
    const double yaw = std::atan2(other.y - one.y, other.x - one.x);
    return {{0.5 * (one.x + other.x), 0.5 * (one.y + other.y), yaw}, 0.2, kBarLength, {}};
  }

  void putRobot(const Pose2d& pose) {
    sim::World world = world_;
    for (const Ends& link : barred_) world.boxes.push_back(boxOn(link));
    sim::SimulationOptions options;
    options.drift = {0.0, 0.0, 0.0};
    simulation_ = std::make_unique<sim::Simulation>(std::move(world), pose, options);
  }

  void goAstray() {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    do {
      astray_ = {any(random_), any(random_), 0.0};
    } while (std::hypot(astray_.x, astray_.y) > 1.0);
    astray_.x *= astray_most_;
    astray_.y *= astray_most_;
    astray_.yaw = any(random_) * kAstrayTurn * astray_most_;
  }

  Pose2d pose() const { return simulation_->base().truth(); }
  Pose2d believed() const {
    return {pose().x + astray_.x, pose().y + astray_.y, core::wrapAngle(pose().yaw + astray_.yaw)};
  }
  nanoseconds now() const { return nanoseconds(std::llround(1e9 * time_)); }

  PlaceId nearest(const Pose2d& spot, const std::vector<PlaceId>& but) const {
    const auto distance = [&](const core::Place& place) {
      if (std::find(but.begin(), but.end(), place.id) != but.end()) return kFar;
      return std::hypot(place.map_from_place.x - spot.x, place.map_from_place.y - spot.y);
    };
    return std::min_element(map_.places().begin(), map_.places().end(),
                            [&](const core::Place& one, const core::Place& other) {
                              return distance(one) < distance(other);
                            })
        ->id;
  }

  core::RoutePlan plan(PlaceId from, PlaceId goal, const core::GoalRun::Avoided& avoided,
                       GoalCounts& counts) {
    core::RouteRequest request;
    request.starts = {{from, 1.0}};
    request.goal = goal;
    request.avoided = avoided;
    core::RoutePlan plan;
    const auto begin = std::chrono::steady_clock::now();
    plan.answer = planner_.plan(request, now());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ++counts.plans;
    counts.longest_plan = std::max(counts.longest_plan, took.count());
    for (const PlaceId id : plan.answer.best.places) plan.best.push_back(*map_.find(id));
    return plan;
  }

  void report(const core::Traversal& traversal) {
    const PlaceLink& link = *map_.findLink(traversal.from, traversal.to);
    const core::LinkDirection& before = traversal.from == link.first ? link.forward : link.backward;
    const core::MapChange change{
        map_.version() + 1,
        traversal.end,
        {core::LinkLearned{traversal.from, traversal.to,
                           core::learned(before, traversal, 10.0, kHalfLife), traversal}}};
    map_.apply(change);
    planner_.follow(change);
  }

  void step(const core::Velocity& velocity, GoalCounts& counts) {
    const Pose2d before = pose();
    simulation_->step(kStep, velocity.forward, velocity.turn);
    time_ += kStep;
    way_ += std::hypot(pose().x - before.x, pose().y - before.y);
    if (!close_at_ || way_ < *close_at_) return;
    close_at_.reset();
    if (close(1 + random_() % 2)) ++counts.closed_ahead;
  }

  void driveLeg(core::GoalRun& run, GoalCounts& counts) {
    core::LegDriver driver({}, run.leg()->target);
    core::EchoRing echoes(std::chrono::milliseconds(500));
    while (!driver.isOver()) {
      const std::vector<double> ranges = simulation_->fire();
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        echoes.hear(static_cast<core::SensorId>(i), now(),
                    sim::sensorPose(simulation_->robot().ring, static_cast<int>(i)), ranges[i]);
      }
      step(driver.update(now(), believed(), echoes), counts);
    }
    if (driver.state() == core::LegDriver::State::kArrived) {
      run.arrived(now());
    } else {
      run.blocked(driver.why(), now());
    }
  }

  std::mt19937_64 random_;
  double astray_most_ = 0.0;  // [m]
  Pose2d astray_;             // from where the robot is to where it takes itself to be
  sim::World world_;
  core::PlaceMap map_;
  core::RoutePlanner planner_;
  std::set<Ends> barred_;
  std::unique_ptr<sim::Simulation> simulation_;
  double time_ = 1.0;               // [s]
  double way_ = 0.0;                // [m]
  std::optional<double> close_at_;  // something closes then
};

}  // namespace

GoalCounts driveGoals(const sim::World& world, int goals, std::uint64_t seed, double astray) {
  Building building(world, seed, astray);
  GoalCounts counts;
  for (int i = 0; i < goals; ++i) {
    building.reopen(3);
    building.goTo(building.anyPlace(), counts);
  }
  return counts;
}

}  // namespace place_memory::routes
