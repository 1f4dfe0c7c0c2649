#ifndef PLACE_MEMORY_TRIALS_SIMULATED_TRIALS_H
#define PLACE_MEMORY_TRIALS_SIMULATED_TRIALS_H

#include <cstdint>
#include <optional>

#include "sim/senses/laser_model.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/world.h"
#include "trials/trial_set.h"

namespace place_memory::trials {

/// What happens between learning a simulated world and coming back to it. Shares are in [0, 1].
struct Recipe {
  int chairs_about_place = 0;       ///< new chairs six feet from the robot (paper 5)
  double doors_flipped = 0.0;       ///< share of the doors
  double chairs_moved = 0.0;        ///< share of the chairs
  double chair_distance = 1.5;      ///< how far those move at the most [m]
  double furniture_moved = 0.0;     ///< share of the boxes and tables
  double furniture_distance = 1.0;  ///< how far those move at the most [m]
  int bicycles_added = 0;
  bool whiteboards_removed = false;
  int people = 0;                  ///< who pass during each scan, learning too
  double shift = 0.0;              ///< how far from the place the robot comes to stand [m]
  bool shift_along_links = false;  ///< only towards or away from linked places (paper 9)
  double compass_error = 0.0;      ///< at recognition, uniform in +- this [rad]
  double drift = 0.0;  ///< heading error learned at the ends of the world, -/+ this [rad] (paper 8)
  double readings_lost = 0.0;               ///< share of the readings that never arrive
  double heading_window = core::kPi / 4.0;  ///< told to the matcher, in [0, pi] [rad]
  bool any_heading = false;              ///< the robot comes back at any heading, with no compass
  double heading_spread = 0.0;           ///< it comes back at headings in +- this [rad]
  std::optional<sim::LaserModel> laser;  ///< scans with this in place of the robot's sonars
  /// A robot with one sensor turns further than it believes, by this share of the turn [1 sigma].
  double turn_error = 0.0;
  /// Comes back instead of the one that learned.
  std::optional<sim::SimulatedRobot> other_robot;
};

/// Learns every place of the world, changes the world and scans each place again. The same
/// arguments give the same trials. Any of several places that are equally near is right (paper 9).
TrialSet simulateTrials(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, std::uint64_t seed);

/// Learns every place of the world; then, `rounds` times, changes the world as the last round left
/// it and scans each place again, round by round. Only bicycles go when others are parked.
TrialSet simulateRounds(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, int rounds, std::uint64_t seed);

/// Learns every place of the world; then the robot goes about, so many scans long, along the links
/// from place to place, and scans at each: the trials, with the way from one to the next.
TrialSet simulateVisits(const sim::World& world, const sim::SimulatedRobot& robot,
                        const Recipe& recipe, std::size_t scans, std::uint64_t seed);

/// Scans of the world's places for a memory that never learned them: nothing is right.
std::vector<RecognitionTrial> simulateStrangers(const sim::World& world,
                                                const sim::SimulatedRobot& robot,
                                                const Recipe& recipe, std::uint64_t seed);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_SIMULATED_TRIALS_H
