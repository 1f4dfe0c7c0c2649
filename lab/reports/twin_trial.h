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

/// What the report of twins named, and what was confused then.
struct TwinScore {
  std::size_t places = 0;
  std::size_t pairs = 0;  ///< that the report calls twins
  std::size_t pairs_confused = 0;
  std::size_t visits = 0;
  std::size_t confusions = 0;  ///< the best match puts the robot more than two metres off
  std::size_t named = 0;       ///< of those between two that the report calls twins
  std::size_t last = 0;        ///< confusions of the last time that the robot came back
  std::size_t last_known = 0;  ///< of those between two that had been confused before

  void add(const TwinScore& other);
};

/// How often the robot comes back to each place, and to what.
struct TwinVisits {
  trials::Recipe recipe;
  int rounds = 1;
};

/// Learns the worlds, which are parts of one map, reports twins, and comes back.
TwinScore tryTwins(const std::vector<sim::World>& worlds, const sim::SimulatedRobot& robot,
                   const TwinVisits& coming_back, std::uint64_t seed,
                   const config::Parameters& parameters, const core::TwinOptions& options);

}  // namespace place_memory::reports

#endif  // PLACE_MEMORY_REPORTS_TWIN_TRIAL_H
