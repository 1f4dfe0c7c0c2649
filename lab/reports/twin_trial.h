#ifndef PLACE_MEMORY_REPORTS_TWIN_TRIAL_H
#define PLACE_MEMORY_REPORTS_TWIN_TRIAL_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "config/parameters.h"
#include "core/memory/twins.h"
#include "sim/world/world.h"
#include "trials/simulated_trials.h"

namespace place_memory::reports {

/// How many of the confusions that followed the report had named.
struct TwinScore {
  std::size_t places = 0;
  std::size_t twins = 0;
  std::size_t visits = 0;
  std::size_t confusions = 0;  ///< the best match puts the robot more than two metres off
  std::size_t named = 0;       ///< of those between two that the report calls twins

  void add(const TwinScore& other);
};

/// Learns the worlds, which are parts of one map, reports twins, and comes back as the recipe says.
TwinScore tryTwins(const std::vector<sim::World>& worlds, const sim::SimulatedRobot& robot,
                   const trials::Recipe& recipe, std::uint64_t seed,
                   const config::Parameters& parameters, const core::TwinOptions& options);

}  // namespace place_memory::reports

#endif  // PLACE_MEMORY_REPORTS_TWIN_TRIAL_H
