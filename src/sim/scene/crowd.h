#ifndef PLACE_MEMORY_SIM_SCENE_CROWD_H
#define PLACE_MEMORY_SIM_SCENE_CROWD_H

#include <cstddef>
#include <vector>

#include "sim/scene/person.h"
#include "sim/scene/scene.h"
#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::sim {

/// People at large in a world, each walking from place to place along the links.
class Crowd {
 public:
  /// `count` people spread over the links of the world. None where the world has no links.
  static Crowd spread(const World& world, int count, Rng& rng);

  /// `count` people who set out some two to seven metres from `point` and pass it, as happens
  /// during a scan (paper, experiments 3 to 5).
  static Crowd passing(const World& world, Vec2 point, int count, Rng& rng);

  /// Moves everyone by `dt` seconds. Nobody comes nearer than an arm to `robot`.
  void step(double dt, Vec2 robot, Rng& rng);

  const std::vector<Circle>& circles() const { return circles_; }

 private:
  explicit Crowd(const World& world);
  void updateCircles(Vec2 robot);

  Walkways ways_;
  std::vector<Person> people_;
  std::vector<Circle> circles_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_CROWD_H
