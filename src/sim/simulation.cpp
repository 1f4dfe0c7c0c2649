#include "place_memory/sim/simulation.h"

#include <utility>

#include "place_memory/sim/world_changes.h"

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

double Simulation::compassHeading() const {
  const core::Pose2d& pose = base_.truth();
  return core::wrapAngle(pose.yaw + compass_.errorAt({pose.x, pose.y}));
}

bool Simulation::placeRobot(const core::Pose2d& pose) {
  if (!pose.isFinite() || !scene_->isFree({pose.x, pose.y}, options_.base_radius)) return false;
  base_.placeAt(pose);
  return true;
}

bool Simulation::setDoor(const std::string& name, bool open) {
  if (!sim::setDoor(world_, name, open)) return false;
  rebuild();
  return true;
}

bool Simulation::moveChair(const std::string& name, const core::Pose2d& pose) {
  if (!pose.isFinite() || !sim::moveChair(world_, name, pose)) return false;
  rebuild();
  return true;
}

bool Simulation::removeWhiteboard(const std::string& name) {
  if (!sim::removeWhiteboard(world_, name)) return false;
  rebuild();
  return true;
}

int Simulation::rearrange(double chairs, double doors, int bicycles) {
  const int changed = moveChairs(world_, chairs, kChairStroll, rng_) +
                      flipDoors(world_, doors, rng_) + addBicycles(world_, bicycles, rng_);
  rebuild();
  return changed;
}

}  // namespace place_memory::sim
