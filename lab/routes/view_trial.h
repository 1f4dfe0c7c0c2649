#ifndef PLACE_MEMORY_LAB_ROUTES_VIEW_TRIAL_H
#define PLACE_MEMORY_LAB_ROUTES_VIEW_TRIAL_H

#include <cstddef>
#include <cstdint>

#include "sim/world/world.h"

namespace place_memory::routes {

/// How a robot that may be at several places goes on.
enum class ViewPolicy {
  kAdvised,  ///< as ViewAdviser says; where no view parts the places, as the other one
  kRandom,   ///< along any link of the place where it most probably is
};

struct ViewTrialRecipe {
  int starts = 20;
  double compass_error = 10.0 * 0.017453292519943295;  ///< at most [rad]
  std::size_t most_scans = 40;                         ///< then it is given up
};

/// What became of robots that were put down somewhere in a building that they know.
struct ViewCounts {
  int starts = 0;
  int unsure = 0;         ///< after the first scan; what follows is of these
  int certain = 0;        ///< became so
  int wrong = 0;          ///< of these, at a wrong place
  std::size_t scans = 0;  ///< until then, the first one too
  double way = 0.0;       ///< driven [m]
  int advised = 0;        ///< views that were advised
  int barred = 0;         ///< ways that something stood in

  void add(const ViewCounts& other);
};

/// Puts a robot down at random in a world whose places it has scanned, and has it scan and drive on
/// until its belief puts 90 % on one spot. The starts depend on the seed alone, not on the policy.
ViewCounts findOneself(const sim::World& world, ViewPolicy policy, const ViewTrialRecipe& recipe,
                       std::uint64_t seed);

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_LAB_ROUTES_VIEW_TRIAL_H
