#ifndef PLACE_MEMORY_TEST_CORE_SENSING_SIMULATED_TURN_H
#define PLACE_MEMORY_TEST_CORE_SENSING_SIMULATED_TURN_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <functional>
#include <random>

#include "core/sensing/sweep_coverage.h"
#include "core/sensing/sweep_turner.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A base as it may be, and its odometry.
struct SimulatedTurn {
  double dead_band = 0.0;  ///< lower rates do nothing [rad/s]
  double delay = 0.0;      ///< from a rate to the turn [s]
  double gain = 1.0;       ///< negative: the sign is swapped
  double quantum = 0.0;    ///< steps of odometry [rad]; 0: fine
  double noise = 0.0;      ///< 1 sigma of odometry [rad]
  double drift = 0.0;      ///< of odometry [rad/s]
};

/// What came of a sweep.
struct Turned {
  bool done = false;
  double yaw = 0.0;      ///< where the base is in the end, from where it began [rad]
  double least = 0.0;    ///< furthest clockwise [rad]
  double most = 0.0;     ///< furthest counter-clockwise [rad]
  double seconds = 0.0;  ///< that it took
  double fastest = 0.0;  ///< rate that was sent [rad/s]
  double shown = 0.0;    ///< when odometry first showed it other than at rest [s]
  int headings = 0;      ///< that were sensed
};

/// Four sensors fire every 0.1 s, the turner is asked twenty times a second.
inline Turned turn(SweepTurner& turner, int headings, double step, const SimulatedTurn& base,
                   double start = 0.0, double longest = 120.0) {
  constexpr double kPeriod = 0.05;
  std::mt19937 rng(1);
  std::normal_distribution<double> normal;
  SweepCoverage coverage(headings, step, {1, 2, 3, 4});
  std::deque<double> sent(static_cast<std::size_t>(std::lround(base.delay / kPeriod)), 0.0);
  Turned result;
  double at_rest = 0.0;
  for (int i = 0; result.seconds < longest && !turner.done() && !turner.base().fault(); ++i) {
    double odometry = start + result.yaw + base.noise * normal(rng) + base.drift * result.seconds;
    if (base.quantum > 0.0) odometry = base.quantum * std::round(odometry / base.quantum);
    if (i == 0) at_rest = odometry;
    if (result.shown == 0.0 && result.yaw != 0.0 &&
        std::abs(odometry - at_rest) > 4.0 * base.noise) {
      result.shown = result.seconds;
    }
    if (turner.started() && !turner.swept() && i % 2 == 0) {
      for (SensorId sensor = 1; sensor <= 4; ++sensor) coverage.add(sensor, wrapAngle(odometry));
    }
    const auto now = std::chrono::nanoseconds(std::chrono::milliseconds(50) * i);
    const bool here_over = coverage.completed() == coverage.headings();
    const double rate = turner.update(now, wrapAngle(odometry), coverage.completed(), here_over);
    sent.push_back(rate);
    const double obeyed = sent.front();
    sent.pop_front();
    if (std::abs(obeyed) >= base.dead_band) result.yaw += base.gain * obeyed * kPeriod;
    result.least = std::min(result.least, result.yaw);
    result.most = std::max(result.most, result.yaw);
    result.fastest = std::max(result.fastest, std::abs(rate));
    result.seconds += kPeriod;
  }
  result.done = turner.done();
  result.headings = coverage.headings();
  return result;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_SENSING_SIMULATED_TURN_H
