#ifndef PLACE_MEMORY_SIM_SCENE_PERSON_H
#define PLACE_MEMORY_SIM_SCENE_PERSON_H

#include <cstddef>
#include <vector>

#include "sim/world/random.h"
#include "sim/world/vec2.h"

namespace place_memory::sim {

/// The paths people may take: straight lines between neighbouring places.
struct Walkways {
  std::vector<Vec2> places;
  std::vector<std::vector<std::size_t>> neighbours;
};

/// Someone who walks from place to place, turning back only at dead ends.
class Person {
 public:
  /// Starts at `from` towards `to`, both indices of linked places.
  Person(std::size_t from, std::size_t to, Rng& rng);

  /// Walks on for `dt` seconds.
  void step(double dt, const Walkways& ways, Rng& rng);

  Vec2 position(const Walkways& ways) const;

  static constexpr double kRadius = 0.2;  ///< of legs and torso as one circle [m]

 private:
  void chooseNext(const Walkways& ways, Rng& rng);

  std::size_t from_;
  std::size_t to_;
  double walked_ = 0.0;    // along the link [m]
  double speed_ = 1.1;     // [m/s]
  double sideways_ = 0.0;  // left of the link's line [m]
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_PERSON_H
