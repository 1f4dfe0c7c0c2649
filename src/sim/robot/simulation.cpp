#include "sim/robot/simulation.h"

#include <cmath>
#include <utility>

#include "sim/scene/world_changes.h"

namespace place_memory::sim {

namespace {

constexpr double kChairStroll = 1.0;  // how far a chair goes in a rearrangement at most [m]

}  // namespace

Simulation::Simulation(World world, const core::Pose2d& start, const SimulationOptions& options)
    : options_(options),
      world_(std::move(world)),
      rng_(options.seed),
      scene_(std::make_unique<Scene>(world_)),
      crowd_(Crowd::spread(world_, options.people, rng_)),
      base_(start, options.base_radius, options.drift, rng_),
      compass_(options.compass_sigma, options.seed) {}

void Simulation::step(double dt, double forward, double turn) {
  base_.step(forward, turn, dt, *scene_);
  crowd_.step(dt, {base_.truth().x, base_.truth().y}, rng_);
}

std::vector<double> Simulation::fire() {
  return fireRing(*scene_, crowd_.circles(), base_.truth(), options_.robot, rng_);
}

std::vector<double> Simulation::sweepLaser(const LaserModel& laser) {
  return laserRanges(*scene_, crowd_.circles(), base_.truth(), laser, rng_);
}

double Simulation::compassHeading() const {
  const core::Pose2d& pose = base_.truth();
  return core::wrapAngle(pose.yaw + compass_.errorAt({pose.x, pose.y}));
}

bool Simulation::placeRobot(const core::Pose2d& pose) {
  const bool inside = std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest;
  if (!pose.isFinite() || !inside || !scene_->isFree({pose.x, pose.y}, options_.base_radius))
    return false;
  base_.placeAt(pose);
  return true;
}

bool Simulation::leavesRoom(const Scene& scene) const {
  const core::Pose2d& robot = base_.truth();
  return scene.isFree({robot.x, robot.y}, options_.base_radius);
}

// A robot that touches something already, driven there, forbids no change.
ChangeResult Simulation::adopt(World changed) {
  auto scene = std::make_unique<Scene>(changed);
  if (leavesRoom(*scene_) && !leavesRoom(*scene)) return ChangeResult::kBlocked;
  world_ = std::move(changed);
  scene_ = std::move(scene);
  return ChangeResult::kDone;
}

ChangeResult Simulation::setDoor(const std::string& name, bool open) {
  World changed = world_;
  if (!sim::setDoor(changed, name, open)) return ChangeResult::kUnknownName;
  return adopt(std::move(changed));
}

ChangeResult Simulation::moveChair(const std::string& name, const core::Pose2d& pose) {
  World changed = world_;
  if (!sim::moveChair(changed, name, pose)) return ChangeResult::kUnknownName;
  const bool inside = std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest;
  if (!pose.isFinite() || !inside) return ChangeResult::kBlocked;
  return adopt(std::move(changed));
}

ChangeResult Simulation::removeWhiteboard(const std::string& name) {
  World changed = world_;
  if (!sim::removeWhiteboard(changed, name)) return ChangeResult::kUnknownName;
  return adopt(std::move(changed));
}

int Simulation::rearrange(double chairs, double doors, int bicycles) {
  World changed = world_;
  // The changes keep clear of places; for them the robot stands at one.
  const core::Pose2d& robot = base_.truth();
  changed.places.push_back({"", {robot.x, robot.y}, {}});
  const int count = moveChairs(changed, chairs, kChairStroll, rng_) +
                    flipDoors(changed, doors, rng_) + addBicycles(changed, bicycles, rng_);
  changed.places.pop_back();
  world_ = std::move(changed);
  scene_ = std::make_unique<Scene>(world_);
  return count;
}

}  // namespace place_memory::sim
