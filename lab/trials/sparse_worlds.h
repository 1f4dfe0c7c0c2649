#ifndef PLACE_MEMORY_TRIALS_SPARSE_WORLDS_H
#define PLACE_MEMORY_TRIALS_SPARSE_WORLDS_H

#include <cstddef>

#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::trials {

/// A yard of 25 to 60 m with up to a thing for every 25 square metres: posts, boxes, chairs. Half
/// of the yards are bare but for a few. Its places, at most `places`, lie amid it, none linked.
sim::World openSpace(std::size_t places, sim::Rng& rng);

/// A hall of 8 to 20 m with furniture along its walls and, in half of them, columns.
sim::World hall(std::size_t places, sim::Rng& rng);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_SPARSE_WORLDS_H
