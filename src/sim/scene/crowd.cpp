#include "sim/scene/crowd.h"

namespace place_memory::sim {

namespace {

constexpr double kArm = 0.75;  // people keep this far from a robot, centre to centre [m]

}  // namespace

Crowd::Crowd(const World& world) {
  for (const Place& place : world.places) ways_.places.push_back(place.position);
  ways_.neighbours = placeNeighbours(world);
}

Crowd Crowd::spread(const World& world, int count, Rng& rng) {
  Crowd crowd(world);
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < crowd.ways_.places.size(); ++i) {
    if (!crowd.ways_.neighbours[i].empty()) starts.push_back(i);
  }
  for (int i = 0; i < count && !starts.empty(); ++i) {
    const std::size_t from = starts[uniformIndex(rng, starts.size())];
    const auto& options = crowd.ways_.neighbours[from];
    crowd.people_.emplace_back(from, options[uniformIndex(rng, options.size())], rng);
    crowd.people_.back().step(uniform(rng, 0.0, 1.0), crowd.ways_, rng);
  }
  for (const Person& person : crowd.people_) {
    crowd.circles_.push_back({person.position(crowd.ways_), Person::kRadius, 0.7});
  }
  return crowd;
}

Crowd Crowd::passing(const World& world, Vec2 point, int count, Rng& rng) {
  Crowd crowd(world);
  std::vector<std::pair<std::size_t, std::size_t>> starts;
  for (std::size_t i = 0; i < crowd.ways_.places.size(); ++i) {
    const double distance = norm(crowd.ways_.places[i] - point);
    if (distance < 2.0 || distance > 7.0) continue;
    for (const std::size_t next : crowd.ways_.neighbours[i]) {
      if (norm(crowd.ways_.places[next] - point) < distance) starts.emplace_back(i, next);
    }
  }
  for (int i = 0; i < count && !starts.empty(); ++i) {
    const auto& [from, to] = starts[uniformIndex(rng, starts.size())];
    crowd.people_.emplace_back(from, to, rng);
  }
  crowd.updateCircles(point);
  return crowd;
}

void Crowd::step(double dt, Vec2 robot, Rng& rng) {
  for (Person& person : people_) person.step(dt, ways_, rng);
  updateCircles(robot);
}

// Whoever would walk over the robot is pushed aside to arm's length.
void Crowd::updateCircles(Vec2 robot) {
  circles_.clear();
  for (const Person& person : people_) {
    Vec2 position = person.position(ways_);
    const Vec2 away = position - robot;
    const double distance = norm(away);
    if (distance < kArm) {
      const Vec2 outwards = distance > 1e-6 ? away * (1.0 / distance) : Vec2{1.0, 0.0};
      position = robot + outwards * kArm;
    }
    circles_.push_back({position, Person::kRadius, 0.7});
  }
}

}  // namespace place_memory::sim
