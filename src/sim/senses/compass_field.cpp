#include "sim/senses/compass_field.h"

#include "place_memory/core/pose2d.h"
#include "sim/world/random.h"

namespace place_memory::sim {

CompassField::CompassField(double sigma, std::uint64_t seed)
    : amplitude_(sigma * std::sqrt(2.0 / static_cast<double>(kWaves))) {
  Rng rng(seed);
  for (Wave& wave : waves_) {
    const double length = uniform(rng, 2.0, 8.0);
    const Vec2 heading = unitVector(uniform(rng, 0.0, 2.0 * core::kPi));
    wave = {heading * (2.0 * core::kPi / length), uniform(rng, 0.0, 2.0 * core::kPi)};
  }
}

double CompassField::errorAt(Vec2 position) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += std::sin(dot(wave.direction, position) + wave.phase);
  return amplitude_ * sum;
}

}  // namespace place_memory::sim
