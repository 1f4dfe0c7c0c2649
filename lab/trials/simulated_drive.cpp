#include "trials/simulated_drive.h"

#include <algorithm>
#include <cmath>

#include "sim/scene/world_changes.h"
#include "sim/senses/sonar_physics.h"

namespace place_memory::trials {
namespace {

constexpr double kThere = 0.15;    // so near to a place it goes on to the next [m]
constexpr double kTurnRate = 0.6;  // [rad/s]
constexpr double kShutIn = 60.0;   // [s]
constexpr double kFar = 4.0;       // so far it is carried at least [m]

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

sim::Rng seeded(std::uint64_t seed) {
  std::seed_seq sequence{seed, seed >> 32U, std::uint64_t{0xd21e}};
  return sim::Rng(sequence);
}

}  // namespace

Wheels::Wheels(const DriveRecipe& recipe, sim::Rng& rng)
    : noise_(recipe.yaw_noise),
      scale_(1.0 + recipe.scale_sigma * sim::normal(rng)),
      turn_(1.0 + recipe.turn_factor_sigma * sim::normal(rng)),
      bend_(recipe.bend_sigma * sim::normal(rng)) {}

double Wheels::believedTurn(double way, double turn, sim::Rng& rng) const {
  return turn * turn_ + bend_ * way + noise_ * std::sqrt(std::abs(way)) * sim::normal(rng);
}

void Wheels::move(double forward, double turn, sim::Rng& rng) {
  const core::Pose2d half{0.0, 0.0, 0.5 * believedTurn(forward, turn, rng)};
  pose_ = pose_ * half * core::Pose2d{forward * scale_, 0.0, 0.0} * half;
}

void Wheels::move(const core::Pose2d& step, sim::Rng& rng) {
  const double believed = believedTurn(std::hypot(step.x, step.y), step.yaw, rng);
  // What the turn is off by is so half way already.
  const core::Pose2d half{0.0, 0.0, 0.5 * (believed - step.yaw)};
  pose_ = pose_ * half * core::Pose2d{scale_ * step.x, scale_ * step.y, 0.0};
  pose_.yaw = core::wrapAngle(pose_.yaw - half.yaw + believed);
}

Drive withErrors(const Drive& drive, const DriveRecipe& recipe, std::uint64_t seed) {
  sim::Rng rng = seeded(seed);
  const sim::CompassField compass(std::max(recipe.compass_sigma, 0.0), seed);
  Wheels wheels(recipe, rng);
  Drive erring = drive;
  core::Pose2d before = drive.empty() ? core::Pose2d{} : drive.front().truth.value();
  for (DriveMoment& moment : erring) {
    const core::Pose2d base = moment.truth.value();
    wheels.move(before.inverse() * base, rng);
    before = base;
    moment.odom = wheels.pose();
    moment.heading.reset();
    if (recipe.compass_sigma < 0.0) continue;
    moment.heading = core::wrapAngle(base.yaw + compass.errorAt({base.x, base.y}) +
                                     recipe.compass_noise * sim::normal(rng));
  }
  return erring;
}

DriveSimulator::DriveSimulator(const sim::World& world, const sim::SimulatedRobot& robot,
                               const DriveRecipe& recipe, std::uint64_t seed)
    : robot_(robot),
      recipe_(recipe),
      rng_(seeded(seed)),
      scene_(std::make_unique<sim::Scene>(world)),
      crowd_(sim::Crowd::spread(world, recipe.people, rng_)),
      compass_(std::max(recipe.compass_sigma, 0.0), seed),
      wheels_(recipe, rng_),
      base_{world.places[recipe.start].position.x, world.places[recipe.start].position.y, 0.0},
      sonars_(recipe.sonars) {
  for (int i = 0; recipe.sonars.empty() && i < robot.ring.count; ++i) sonars_.push_back(i);
}

DriveSimulator::Step DriveSimulator::step(double forward, double turn) {
  Step step;
  const core::Pose2d moved =
      base_ * core::Pose2d{0.0, 0.0, 0.5 * turn} * core::Pose2d{forward, 0.0, 0.5 * turn};
  step.is_blocked = forward != 0.0 && !scene_->isFree({moved.x, moved.y}, kBaseRadius) &&
                    scene_->isFree({base_.x, base_.y}, kBaseRadius);
  if (!step.is_blocked) {
    base_ = moved;
    step.forward = forward;
  }
  wheels_.move(step.forward, step.is_blocked ? 0.0 : turn, rng_);
  t_ += recipe_.tick;
  crowd_.step(recipe_.tick, {base_.x, base_.y}, rng_);

  DriveMoment& moment = step.moment;
  moment.t = t_;
  moment.odom = wheels_.pose();
  moment.truth = base_;
  if (recipe_.compass_sigma >= 0.0) {
    moment.heading = core::wrapAngle(base_.yaw + compass_.errorAt({base_.x, base_.y}) +
                                     recipe_.compass_noise * sim::normal(rng_));
  }
  const auto round = static_cast<std::size_t>(recipe_.round);
  for (std::size_t i = next_; i < sonars_.size(); i += round) {
    const core::Pose2d sensor = sim::sensorPose(robot_.ring, sonars_[i]);
    const double range = sim::pingSonar(*scene_, crowd_.circles(), base_ * sensor, robot_.ring.spec,
                                        robot_.physics, rng_);
    if (range < robot_.ring.spec.min_range) continue;
    moment.readings.push_back({sensor, robot_.ring.spec, range});
  }
  next_ = (next_ + 1) % round;
  return step;
}

Drive simulateDrive(const sim::World& world, const sim::SimulatedRobot& robot,
                    const DriveRecipe& recipe, std::uint64_t seed) {
  DriveSimulator simulator(world, robot, recipe, seed);
  sim::Rng& rng = simulator.rng();
  Wanderer wanderer(world, recipe.start);
  Drive drive;
  double way = 0.0, t = 0.0;
  int blocked = 0;
  double moved_at = 0.0;
  double next_change = recipe.change_every > 0.0 ? recipe.change_every : 0.5 * recipe.way;
  if (!recipe.changes) next_change = INFINITY;
  std::size_t carried = 0;
  while (way < recipe.way && t < 20.0 * recipe.way / recipe.speed) {
    // Behind closed doors it waits until somebody comes by.
    const bool is_shut_in = recipe.changes && t - moved_at > kShutIn;
    if (way > next_change || is_shut_in) {
      moved_at = t;
      if (way > next_change) {
        next_change = recipe.change_every > 0.0 ? next_change + recipe.change_every : INFINITY;
      }
      sim::World now = world;
      change(now, simulator.base(), rng);
      simulator.setWorld(now);
    }
    if (carried < recipe.carried.size() && way > recipe.carried[carried]) {
      ++carried;
      const std::size_t to = farPlace(world, simulator.base(), rng);
      const sim::Vec2& spot = world.places[to].position;
      simulator.putAt({spot.x, spot.y, core::wrapAngle(2.0 * core::kPi * sim::uniform(rng))});
      wanderer.putAt(to);
    }
    const core::Pose2d base = simulator.base();
    const sim::Vec2 goal = world.places[wanderer.target(rng)].position;
    const double distance = std::hypot(goal.x - base.x, goal.y - base.y);
    if (distance < kThere) {
      wanderer.arrive();
      continue;
    }
    const double off = core::wrapAngle(std::atan2(goal.y - base.y, goal.x - base.x) - base.yaw);
    const double turn = std::clamp(off, -kTurnRate * recipe.tick, kTurnRate * recipe.tick);
    DriveSimulator::Step step =
        simulator.step(std::abs(off) < 0.5 ? recipe.speed * recipe.tick : 0.0, turn);
    if (step.is_blocked && ++blocked > 10) {
      blocked = 0;
      wanderer.turnBack();
    }
    way += step.forward;
    t += recipe.tick;
    if (step.forward > 0.0) moved_at = t;
    drive.push_back(std::move(step.moment));
  }
  return drive;
}

}  // namespace place_memory::trials
