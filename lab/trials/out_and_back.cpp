#include "trials/out_and_back.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_memory::trials {
namespace {

constexpr double kThere = 0.08;      // so near to a place it goes on to the next [m]
constexpr double kTurnRate = 0.6;    // [rad/s]
constexpr double kPatience = 20.0;   // with what stands in the way [s]
constexpr double kTurnsFirst = 0.5;  // off its course by more than this it turns on the spot [rad]

/// Ways from one place to all others (Dijkstra 1959), and the place before each.
struct Ways {
  std::vector<double> length;  ///< [m]
  std::vector<std::size_t> before;
};

Ways waysFrom(const sim::World& world, const std::vector<std::vector<std::size_t>>& links,
              std::size_t from) {
  const double unknown = std::numeric_limits<double>::infinity();
  Ways ways{std::vector<double>(links.size(), unknown),
            std::vector<std::size_t>(links.size(), from)};
  std::vector<char> settled(links.size(), 0);
  ways.length[from] = 0.0;
  for (std::size_t round = 0; round < links.size(); ++round) {
    std::size_t at = links.size();
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (!settled[i] && (at == links.size() || ways.length[i] < ways.length[at])) at = i;
    }
    settled[at] = 1;
    const sim::Vec2 here = world.places[at].position;
    for (const std::size_t next : links[at]) {
      const sim::Vec2 there = world.places[next].position;
      const double length = ways.length[at] + std::hypot(there.x - here.x, there.y - here.y);
      if (length >= ways.length[next]) continue;
      ways.length[next] = length;
      ways.before[next] = at;
    }
  }
  return ways;
}

/// Drives on to a spot; false where something stands in the way.
bool driveTo(DriveSimulator& simulator, const DriveRecipe& recipe, sim::Vec2 goal, Drive& drive) {
  double blocked = 0.0;
  while (blocked < kPatience) {
    const core::Pose2d& base = simulator.base();
    if (std::hypot(goal.x - base.x, goal.y - base.y) < kThere) return true;
    const double off = core::wrapAngle(std::atan2(goal.y - base.y, goal.x - base.x) - base.yaw);
    const double turn = std::clamp(off, -kTurnRate * recipe.tick, kTurnRate * recipe.tick);
    const double forward = std::abs(off) < kTurnsFirst ? recipe.speed * recipe.tick : 0.0;
    DriveSimulator::Step step = simulator.step(forward, turn);
    if (step.is_blocked) blocked += recipe.tick;
    drive.push_back(std::move(step.moment));
  }
  return false;
}

}  // namespace

std::vector<std::size_t> longestWay(const sim::World& world) {
  const auto links = sim::placeNeighbours(world);
  std::vector<std::size_t> longest;
  double length = -1.0;
  for (std::size_t from = 0; from < links.size(); ++from) {
    const Ways ways = waysFrom(world, links, from);
    for (std::size_t to = 0; to < links.size(); ++to) {
      if (!std::isfinite(ways.length[to]) || ways.length[to] <= length) continue;
      length = ways.length[to];
      longest = {to};
      while (longest.back() != from) longest.push_back(ways.before[longest.back()]);
    }
  }
  std::reverse(longest.begin(), longest.end());
  return longest;
}

Drive driveOutAndBack(sim::World world, const sim::SimulatedRobot& robot, DriveRecipe recipe,
                      const std::vector<std::size_t>& places, std::uint64_t seed) {
  for (sim::Door& door : world.doors) door.open = true;
  recipe.start = places.front();
  DriveSimulator simulator(world, robot, recipe, seed);
  Drive drive;
  std::size_t next = 1;
  while (next < places.size() &&
         driveTo(simulator, recipe, world.places[places[next]].position, drive)) {
    ++next;
  }
  while (next-- > 0) {
    if (!driveTo(simulator, recipe, world.places[places[next]].position, drive)) break;
  }
  return drive;
}

}  // namespace place_memory::trials
