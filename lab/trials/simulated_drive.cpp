#include "trials/simulated_drive.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/scene/crowd.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_changes.h"
#include "sim/senses/compass_field.h"
#include "sim/senses/sonar_physics.h"
#include "sim/world/random.h"

namespace place_memory::trials {
namespace {

constexpr double kBaseRadius = 0.22;  // [m]
constexpr double kThere = 0.15;       // so near to a place it goes on to the next [m]
constexpr double kTurnRate = 0.6;     // [rad/s]
constexpr double kFar = 4.0;          // so far it is carried at least [m]

/// Where the robot goes next: where it has been least.
class Wanderer {
 public:
  Wanderer(const sim::World& world, std::size_t start)
      : neighbours_(sim::placeNeighbours(world)), visits_(world.places.size(), 0), at_(start) {
    ++visits_[at_];
  }

  std::size_t target(sim::Rng& rng) {
    if (target_) return *target_;
    const std::vector<std::size_t>& options = neighbours_[at_];
    double best = 1e9;
    std::size_t chosen = options.front();
    for (const std::size_t option : options) {
      double cost = visits_[option] + 0.5 * sim::uniform(rng);
      if (option == from_ && options.size() > 1) cost += 2.0;
      if (cost < best) {
        best = cost;
        chosen = option;
      }
    }
    target_ = chosen;
    return chosen;
  }

  void arrive() {
    from_ = at_;
    at_ = *target_;
    ++visits_[at_];
    target_.reset();
  }
  /// Somebody carried the robot to that place.
  void putAt(std::size_t place) {
    from_ = static_cast<std::size_t>(-1);
    at_ = place;
    target_.reset();
    ++visits_[at_];
  }
  /// Something stands in the way.
  void turnBack() {
    visits_[*target_] += 3;
    std::swap(at_, *target_);
  }

 private:
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<int> visits_;
  std::size_t at_;
  std::size_t from_ = static_cast<std::size_t>(-1);
  std::optional<std::size_t> target_;
};

/// A place that is not near, any of them.
std::size_t farPlace(const sim::World& world, const core::Pose2d& base, sim::Rng& rng) {
  std::vector<std::size_t> far;
  double farthest = 0.0;
  std::size_t last_resort = 0;
  for (std::size_t i = 0; i < world.places.size(); ++i) {
    const sim::Vec2& spot = world.places[i].position;
    const double distance = std::hypot(spot.x - base.x, spot.y - base.y);
    if (distance >= kFar) far.push_back(i);
    if (distance <= farthest) continue;
    farthest = distance;
    last_resort = i;
  }
  return far.empty() ? last_resort : far[sim::uniformIndex(rng, far.size())];
}

/// The lasting changes of a working day.
void change(sim::World& world, const core::Pose2d& base, sim::Rng& rng) {
  world.places.push_back({"", {base.x, base.y}, {}});
  sim::moveChairs(world, 0.5, 1.0, rng);
  sim::flipDoors(world, 0.3, rng);
  sim::addBicycles(world, 2, rng);
  world.places.pop_back();
}

/// Odometry that errs by the recipe.
class Wheels {
 public:
  Wheels(const DriveRecipe& recipe, sim::Rng& rng)
      : noise_(recipe.yaw_noise),
        scale_(1.0 + recipe.scale_sigma * sim::normal(rng)),
        turn_(1.0 + recipe.turn_factor_sigma * sim::normal(rng)),
        bend_(recipe.bend_sigma * sim::normal(rng)) {}

  void move(double forward, double turn, sim::Rng& rng) {
    const double believed =
        turn * turn_ + bend_ * forward + noise_ * std::sqrt(std::abs(forward)) * sim::normal(rng);
    const core::Pose2d half{0.0, 0.0, 0.5 * believed};
    pose_ = pose_ * half * core::Pose2d{forward * scale_, 0.0, 0.0} * half;
  }
  const core::Pose2d& pose() const { return pose_; }

 private:
  double noise_, scale_, turn_, bend_;
  core::Pose2d pose_;
};

}  // namespace

Drive simulateDrive(const sim::World& world, const sim::SimulatedRobot& robot,
                    const DriveRecipe& recipe, std::uint64_t seed) {
  std::seed_seq sequence{seed, seed >> 32U, std::uint64_t{0xd21e}};
  sim::Rng rng(sequence);
  sim::World now = world;
  auto scene = std::make_unique<sim::Scene>(now);
  sim::Crowd crowd = sim::Crowd::spread(now, recipe.people, rng);
  const sim::CompassField compass(std::max(recipe.compass_sigma, 0.0), seed);
  Wanderer wanderer(world, recipe.start);
  Wheels wheels(recipe, rng);
  std::vector<int> sonars = recipe.sonars;
  for (int i = 0; sonars.empty() || (recipe.sonars.empty() && i < robot.ring.count); ++i) {
    sonars.push_back(i);
  }
  const sim::Vec2 start = world.places[recipe.start].position;
  core::Pose2d base{start.x, start.y, 0.0};
  Drive drive;
  double way = 0.0, t = 0.0;
  std::size_t next = 0;
  int blocked = 0;
  double next_change = recipe.change_every > 0.0 ? recipe.change_every : 0.5 * recipe.way;
  if (!recipe.changes) next_change = INFINITY;
  std::size_t carried = 0;
  while (way < recipe.way && t < 20.0 * recipe.way / recipe.speed) {
    if (way > next_change) {
      next_change = recipe.change_every > 0.0 ? next_change + recipe.change_every : INFINITY;
      now = world;
      change(now, base, rng);
      scene = std::make_unique<sim::Scene>(now);
    }
    if (carried < recipe.carried.size() && way > recipe.carried[carried]) {
      ++carried;
      const std::size_t to = farPlace(world, base, rng);
      const sim::Vec2& spot = world.places[to].position;
      base = {spot.x, spot.y, core::wrapAngle(2.0 * core::kPi * sim::uniform(rng))};
      wanderer.putAt(to);
    }
    const sim::Vec2 goal = world.places[wanderer.target(rng)].position;
    const double distance = std::hypot(goal.x - base.x, goal.y - base.y);
    if (distance < kThere) {
      wanderer.arrive();
      continue;
    }
    const double off = core::wrapAngle(std::atan2(goal.y - base.y, goal.x - base.x) - base.yaw);
    const double turn = std::clamp(off, -kTurnRate * recipe.tick, kTurnRate * recipe.tick);
    double forward = std::abs(off) < 0.5 ? recipe.speed * recipe.tick : 0.0;
    const core::Pose2d moved =
        base * core::Pose2d{0.0, 0.0, 0.5 * turn} * core::Pose2d{forward, 0.0, 0.5 * turn};
    if (forward > 0.0 && !scene->isFree({moved.x, moved.y}, kBaseRadius) &&
        scene->isFree({base.x, base.y}, kBaseRadius)) {
      forward = 0.0;
      if (++blocked > 10) {
        blocked = 0;
        wanderer.turnBack();
      }
    } else {
      base = moved;
    }
    wheels.move(forward, forward > 0.0 || base.yaw == moved.yaw ? turn : 0.0, rng);
    way += forward;
    t += recipe.tick;
    crowd.step(recipe.tick, {base.x, base.y}, rng);

    DriveMoment moment;
    moment.t = t;
    moment.odom = wheels.pose();
    moment.truth = base;
    if (recipe.compass_sigma >= 0.0) {
      moment.heading = core::wrapAngle(base.yaw + compass.errorAt({base.x, base.y}) +
                                       recipe.compass_noise * sim::normal(rng));
    }
    for (std::size_t i = next; i < sonars.size(); i += static_cast<std::size_t>(recipe.round)) {
      const core::Pose2d sensor = sim::sensorPose(robot.ring, sonars[i]);
      const double range = sim::pingSonar(*scene, crowd.circles(), base * sensor, robot.ring.spec,
                                          robot.physics, rng);
      if (range < robot.ring.spec.min_range) continue;
      moment.readings.push_back({sensor, robot.ring.spec, range});
    }
    next = (next + 1) % static_cast<std::size_t>(recipe.round);
    drive.push_back(std::move(moment));
  }
  return drive;
}

}  // namespace place_memory::trials
