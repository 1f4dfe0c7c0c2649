#include "trials/simulated_trials.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/scene/crowd.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_changes.h"
#include "sim/scene/world_loader.h"
#include "sim/world/random.h"

namespace place_memory::trials {
namespace {

using core::Pose2d;
using sim::Rng;
using sim::uniform;

/// Places whose distances differ by less are equally near [m].
constexpr double kEquallyNear = 0.15;

/// So many purposes has chance in one round.
constexpr std::uint64_t kPurposes = 3;

/// The generator of one scan, so that no scan depends on how much chance another one used.
Rng generatorOf(std::uint64_t seed, std::uint64_t purpose, std::uint64_t place) {
  std::seed_seq sequence{seed, seed >> 32U, purpose, place};
  return Rng(sequence);
}

class Simulation {
 public:
  Simulation(const sim::World& world, const sim::SimulatedRobot& robot, const Recipe& recipe,
             std::uint64_t seed)
      : world_(world),
        robot_(robot),
        recipe_(recipe),
        seed_(seed),
        scene_(world),
        changed_(world),
        changed_scene_(world) {
    for (const sim::Place& place : world_.places) {
      west_ = std::min(west_, place.position.x);
      east_ = std::max(east_, place.position.x);
    }
  }

  /// Changes the world as it is by now. What follows is of this round.
  void change(int round) {
    round_ = round;
    Rng rng = generatorOf(seed_, 3 + kPurposes * static_cast<std::uint64_t>(round), 0);
    changed_.bicycles = world_.bicycles;
    sim::flipDoors(changed_, recipe_.doors_flipped, rng);
    sim::moveChairs(changed_, recipe_.chairs_moved, recipe_.chair_distance, rng);
    sim::addBicycles(changed_, recipe_.bicycles_added, rng);
    sim::moveFurniture(changed_, recipe_.furniture_moved, recipe_.furniture_distance, rng);
    if (recipe_.whiteboards_removed) changed_.whiteboards.clear();
    changed_scene_ = sim::Scene(changed_);
  }

  /// Nothing changes, but chance is another.
  void comeBack(int round) { round_ = round; }

  /// Where the base was at the newest scan.
  const Pose2d& base() const { return base_; }

  LearnedScan learn(std::size_t index) {
    const sim::Place& place = world_.places[index];
    Rng rng = generatorOf(seed_, 1, index);
    const double yaw = recipe_.any_heading ? uniform(rng, -core::kPi, core::kPi) : 0.0;
    const double error = driftAt(place.position.x);
    const Pose2d base{place.position.x, place.position.y, yaw};
    return {place.label, scanFrame(base, error), scan(robot_, world_, scene_, base, error, rng)};
  }

  RecognitionTrial recognize(std::size_t index) {
    const sim::Place& place = world_.places[index];
    Rng rng = generatorOf(seed_, 2 + kPurposes * static_cast<std::uint64_t>(round_), index);
    sim::World world = changed_;
    if (recipe_.chairs_about_place > 0) {
      sim::addChairs(world, place.position, recipe_.chairs_about_place, rng);
    }
    const sim::Scene own_scene =
        recipe_.chairs_about_place > 0 ? sim::Scene(world) : changed_scene_;
    const Pose2d base = standingPose(index, own_scene, rng);
    base_ = base;
    const double error = recipe_.any_heading
                             ? uniform(rng, -core::kPi, core::kPi)
                             : uniform(rng, -recipe_.compass_error, recipe_.compass_error);
    RecognitionTrial trial;
    trial.accept = nearestPlaces(base);
    trial.round = round_;
    trial.odom_from_scan = scanFrame(base, error);
    trial.heading_window = recipe_.any_heading ? core::kPi : recipe_.heading_window;
    trial.readings = scan(recipe_.other_robot.value_or(robot_), world, own_scene, base, error, rng);
    return trial;
  }

 private:
  /// Dead reckoning drifts as the robot goes: from -drift in the west to +drift in the east.
  double driftAt(double x) const {
    const double middle = 0.5 * (west_ + east_);
    const double half = std::max(0.5 * (east_ - west_), 1e-9);
    return recipe_.drift * (x - middle) / half;
  }

  static Pose2d scanFrame(const Pose2d& base, double compass_error) {
    return {base.x, base.y, core::wrapAngle(-compass_error)};
  }

  /// At the place, or `shift` from it where the robot can drive; as near to that as there is room.
  Pose2d standingPose(std::size_t index, const sim::Scene& scene, Rng& rng) const {
    const sim::Place& place = world_.places[index];
    double yaw = recipe_.any_heading ? uniform(rng, -core::kPi, core::kPi) : 0.0;
    if (recipe_.heading_spread > 0.0) {
      yaw += uniform(rng, -recipe_.heading_spread, recipe_.heading_spread);
    }
    constexpr int kTries = 24;
    double shift = recipe_.shift;
    while (shift > 0.05) {
      for (int attempt = 0; attempt < kTries; ++attempt) {
        const double bearing = shiftBearing(index, rng);
        const sim::Vec2 to{place.position.x + shift * std::cos(bearing),
                           place.position.y + shift * std::sin(bearing)};
        if (scene.isPathFree(place.position, to, sim::kPlaceClearance)) return {to.x, to.y, yaw};
      }
      shift *= 0.75;
    }
    return {place.position.x, place.position.y, yaw};
  }

  double shiftBearing(std::size_t index, Rng& rng) const {
    const auto& near = neighbours_[index];
    if (!recipe_.shift_along_links || near.empty()) return uniform(rng, -core::kPi, core::kPi);
    const sim::Vec2 from = world_.places[index].position;
    const sim::Vec2 to = world_.places[near[sim::uniformIndex(rng, near.size())]].position;
    return std::atan2(to.y - from.y, to.x - from.x);
  }

  std::vector<std::string> nearestPlaces(const Pose2d& base) const {
    double least = INFINITY;
    for (const sim::Place& place : world_.places) {
      least = std::min(least, std::hypot(place.position.x - base.x, place.position.y - base.y));
    }
    std::vector<std::string> labels;
    for (const sim::Place& place : world_.places) {
      const double distance = std::hypot(place.position.x - base.x, place.position.y - base.y);
      if (distance <= least + kEquallyNear) labels.push_back(place.label);
    }
    return labels;
  }

  std::vector<core::SonarReading> scan(const sim::SimulatedRobot& robot, const sim::World& world,
                                       const sim::Scene& scene, const Pose2d& base, double error,
                                       Rng& rng) const {
    std::optional<sim::Crowd> crowd;
    if (recipe_.people > 0) {
      crowd = sim::Crowd::passing(world, {base.x, base.y}, recipe_.people, rng);
    }
    std::vector<core::SonarReading> readings;
    if (recipe_.laser) {
      const std::vector<sim::Circle> people = crowd ? crowd->circles() : std::vector<sim::Circle>();
      readings = sim::simulateLaserScan(scene, people, base, error, *recipe_.laser, rng);
    } else {
      readings = sim::simulateScan(scene, base, error, robot, crowd ? &*crowd : nullptr, rng);
    }
    if (recipe_.turn_error > 0.0 && robot.ring.count == 1)
      misjudgeTurn(base, error, robot, rng, readings);
    const auto lost = [&](const core::SonarReading&) {
      return sim::chance(rng, recipe_.readings_lost);
    };
    readings.erase(std::remove_if(readings.begin(), readings.end(), lost), readings.end());
    return readings;
  }

  /// What the readings look like to a robot that errs by the same share all through its turn.
  void misjudgeTurn(const Pose2d& base, double compass_error, const sim::SimulatedRobot& robot,
                    Rng& rng, std::vector<core::SonarReading>& readings) const {
    const double share = recipe_.turn_error * sim::normal(rng);
    const double start = base.yaw + compass_error + robot.ring.first_bearing;
    const double sign = robot.sweep.step < 0.0 ? -1.0 : 1.0;
    for (core::SonarReading& reading : readings) {
      double turned = std::fmod(sign * (reading.sensor_pose.yaw - start), 2.0 * core::kPi);
      if (turned < 0.0) turned += 2.0 * core::kPi;
      reading.sensor_pose = Pose2d{0.0, 0.0, sign * share * turned} * reading.sensor_pose;
    }
  }

  const sim::World& world_;
  const sim::SimulatedRobot& robot_;
  const Recipe& recipe_;
  std::uint64_t seed_;
  int round_ = 0;
  sim::Scene scene_;
  sim::World changed_;
  sim::Scene changed_scene_;
  Pose2d base_;
  std::vector<std::vector<std::size_t>> neighbours_ = sim::placeNeighbours(world_);
  double west_ = INFINITY;
  double east_ = -INFINITY;
};

/// In steps of a foot or so, turning evenly.
std::vector<Pose2d> straightWay(const Pose2d& from, const Pose2d& to) {
  constexpr double kStep = 0.35;  // [m]
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double turn = core::wrapAngle(to.yaw - from.yaw);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(dx, dy) / kStep)));
  std::vector<Pose2d> way;
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    way.push_back(
        {from.x + share * dx, from.y + share * dy, core::wrapAngle(from.yaw + share * turn)});
  }
  return way;
}

/// Any neighbour but the one where the robot comes from, unless there is no other.
std::size_t nextPlace(std::vector<std::size_t> neighbours, std::size_t from, Rng& rng) {
  if (neighbours.size() > 1) {
    neighbours.erase(std::remove(neighbours.begin(), neighbours.end(), from), neighbours.end());
  }
  return neighbours.empty() ? from : neighbours[sim::uniformIndex(rng, neighbours.size())];
}

}  // namespace

TrialSet simulateTrials(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, std::uint64_t seed) {
  return simulateRounds(world, robot, recipe, 1, seed);
}

TrialSet simulateRounds(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, int rounds, std::uint64_t seed) {
  Simulation simulation(world, robot, recipe, seed);
  TrialSet set;
  set.name = world.name;
  set.turns_truly = recipe.turn_error == 0.0;
  for (std::size_t i = 0; i < world.places.size(); ++i) set.learned.push_back(simulation.learn(i));
  for (int round = 0; round < rounds; ++round) {
    simulation.change(round);
    for (std::size_t i = 0; i < world.places.size(); ++i) {
      set.trials.push_back(simulation.recognize(i));
    }
  }
  return set;
}

TrialSet simulateVisits(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, std::size_t scans, std::uint64_t seed) {
  Simulation simulation(world, robot, recipe, seed);
  TrialSet set;
  set.name = world.name;
  set.turns_truly = recipe.turn_error == 0.0;
  for (std::size_t i = 0; i < world.places.size(); ++i) set.learned.push_back(simulation.learn(i));
  const auto neighbours = sim::placeNeighbours(world);
  Rng rng = generatorOf(seed, 0, 0);
  std::size_t at = sim::uniformIndex(rng, world.places.size());
  std::size_t from = at;
  std::vector<int> times(world.places.size(), 0);
  simulation.change(0);
  for (std::size_t scan = 0; scan < scans; ++scan) {
    simulation.comeBack(times[at]++);
    RecognitionTrial trial = simulation.recognize(at);
    trial.way = set.trials.empty() ? std::vector<Pose2d>{simulation.base()}
                                   : straightWay(set.trials.back().way.back(), simulation.base());
    set.trials.push_back(std::move(trial));
    from = std::exchange(at, nextPlace(neighbours[at], from, rng));
  }
  return set;
}

std::vector<RecognitionTrial> simulateStrangers(const sim::World& world,
                                                const sim::SimulatedRobot& robot,
                                                const Recipe& recipe, std::uint64_t seed) {
  Simulation simulation(world, robot, recipe, seed);
  simulation.change(0);
  std::vector<RecognitionTrial> strangers;
  for (std::size_t i = 0; i < world.places.size(); ++i) {
    strangers.push_back(simulation.recognize(i));
    strangers.back().accept.clear();
  }
  return strangers;
}

}  // namespace place_memory::trials
