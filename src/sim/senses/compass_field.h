#ifndef PLACE_MEMORY_SIM_SENSES_COMPASS_FIELD_H
#define PLACE_MEMORY_SIM_SENSES_COMPASS_FIELD_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/world/vec2.h"

namespace place_memory::sim {

/// The compass error that iron in a building causes: it depends on where the robot is and is the
/// same each time it comes back (paper, section 4: repeatable within ten degrees for a given
/// location).
class CompassField {
 public:
  /// `sigma` [rad] is the error's spread over the building; it swings over some two to eight
  /// metres.
  CompassField(double sigma, std::uint64_t seed);

  /// What the compass adds to the true heading at `position` [rad].
  double errorAt(Vec2 position) const;

 private:
  struct Wave {
    Vec2 direction;  // of the wave vector, times wave number [rad/m]
    double phase;
  };

  static constexpr std::size_t kWaves = 6;

  double amplitude_;
  std::array<Wave, kWaves> waves_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SENSES_COMPASS_FIELD_H
