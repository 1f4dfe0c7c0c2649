#ifndef PLACE_MEMORY_SIM_WORLD_RANDOM_H
#define PLACE_MEMORY_SIM_WORLD_RANDOM_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace place_memory::sim {

/// The generator whose raw output the C++ standard fixes. The std distributions are left aside:
/// their algorithms are the library's own, so that a seed would mean another world elsewhere.
using Rng = std::mt19937_64;

/// Uniform in [0, 1).
inline double uniform(Rng& rng) { return static_cast<double>(rng() >> 11U) * 0x1.0p-53; }

/// Uniform in [low, high).
inline double uniform(Rng& rng, double low, double high) {
  return low + (high - low) * uniform(rng);
}

/// Uniform in 0 .. count - 1; `count` >= 1.
inline std::size_t uniformIndex(Rng& rng, std::size_t count) {
  const auto index = static_cast<std::size_t>(uniform(rng) * static_cast<double>(count));
  return index < count ? index : count - 1;
}

/// Uniform in low .. high, both included.
inline int uniformInt(Rng& rng, int low, int high) {
  return low + static_cast<int>(uniformIndex(rng, static_cast<std::size_t>(high - low) + 1));
}

inline bool chance(Rng& rng, double probability) { return uniform(rng) < probability; }

/// Standard normal, by Marsaglia's polar method.
inline double normal(Rng& rng) {
  for (;;) {
    const double u = uniform(rng, -1.0, 1.0);
    const double v = uniform(rng, -1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * std::log(s) / s);
  }
}

template <typename T>
void shuffle(std::vector<T>& items, Rng& rng) {
  for (std::size_t i = items.size(); i > 1; --i) {
    using std::swap;
    swap(items[i - 1], items[uniformIndex(rng, i)]);
  }
}

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_WORLD_RANDOM_H
