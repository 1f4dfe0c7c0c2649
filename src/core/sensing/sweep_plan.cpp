#include "core/sensing/sweep_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr int kPaperHeadings = 11;
constexpr double kPaperStep = 2.0 * kDegree;
constexpr double kPaperTurn = (kPaperHeadings - 1) * kPaperStep;
constexpr double kFewestReadings = 96.0;
constexpr double kStepsInARun = 4.0;  // a run of cones looks at every spot so often
constexpr int kMostHeadings = 3600;
constexpr double kAtAHeading = 0.8;  // [s], to come to it, to stand and to listen
constexpr double kTiny = 1e-9;

// What the cones of all sensors leave open, and where they lie close together.
struct Layout {
  double gap = -2.0 * kPi;  // the widest between two cones [rad]; <= 0: there is none
  double turn = 0.0;        // that closes every gap [rad]
  double run = 2.0 * kPi;   // the narrowest sector without a gap that turns into a gap [rad]
};

Layout layoutOf(std::vector<SensorMount> sensors) {
  for (SensorMount& sensor : sensors) sensor.bearing = wrapAngle(sensor.bearing);
  std::sort(sensors.begin(), sensors.end(),
            [](const SensorMount& a, const SensorMount& b) { return a.bearing < b.bearing; });
  Layout layout;
  double run = sensors.front().field_of_view;
  // Twice around: a run may go across the bearing at which the order begins.
  for (std::size_t i = 0; i < 2 * sensors.size(); ++i) {
    const SensorMount& a = sensors[i % sensors.size()];
    const SensorMount& b = sensors[(i + 1) % sensors.size()];
    const bool across = (i + 1) % sensors.size() == 0;
    const double apart = b.bearing - a.bearing + (across ? 2.0 * kPi : 0.0);
    const double width = 0.5 * (a.field_of_view + b.field_of_view);
    layout.gap = std::max(layout.gap, apart - width);
    layout.turn = std::max(layout.turn, apart - 0.5 * width);
    if (apart - width <= kTiny) {
      run = std::max(run + apart, b.field_of_view);
      continue;
    }
    if (i >= sensors.size() || sensors.size() == 1) layout.run = std::min(layout.run, run);
    run = b.field_of_view;
  }
  return layout;
}

std::string degrees(double angle) {
  std::ostringstream text;
  text << std::setprecision(3) << angle / kDegree << " degrees";
  return text.str();
}

std::string whatTheyLeave(std::size_t sensors, const Layout& layout) {
  if (sensors == 1) {
    return "a single sensor leaves a gap of " + degrees(layout.gap) + " around its cone";
  }
  const std::string count = std::to_string(sensors) + " sensors";
  if (layout.gap <= kTiny) return "the cones of " + count + " leave no gap";
  return count + " leave a gap of " + degrees(layout.gap) + " between their cones";
}

}  // namespace

bool SweepPlan::isFullTurn() const { return headings * step > 2.0 * kPi - 0.5 * step; }

SweepPlan planSweep(const std::vector<SensorMount>& sensors, double step) {
  SweepPlan plan;
  plan.step = step > 0.0 ? step : kPaperStep;
  if (sensors.empty()) {
    plan.headings = kPaperHeadings;
    plan.reason =
        "no sensor was heard that tf places on the robot: 11 headings, as for a full ring";
    return plan;
  }
  const Layout layout = layoutOf(sensors);
  const bool full = layout.turn > kPi;
  const double turn = full ? 2.0 * kPi : std::max(layout.turn, kPaperTurn);
  if (step <= 0.0 && turn > kPaperTurn) {
    const double few = turn * static_cast<double>(sensors.size()) / kFewestReadings;
    plan.step = std::max(std::min(layout.run / kStepsInARun, few), kPaperStep);
  }
  const int steps = std::min(static_cast<int>(std::ceil(turn / plan.step - kTiny)),
                             full ? kMostHeadings : kMostHeadings - 1);
  plan.headings = full ? steps : steps + 1;
  if (full && step <= 0.0) plan.step = turn / steps;
  plan.reason =
      whatTheyLeave(sensors.size(), layout) + ": " +
      (full ? "a full turn is needed" : "a turn of " + degrees(steps * plan.step) + " is enough") +
      ", " + std::to_string(plan.headings) + " headings";
  return plan;
}

double reckonedSeconds(const SweepPlan& plan, double max_rate) {
  const double turn = plan.step * plan.headings;
  const double way = plan.isFullTurn() ? 2.0 * kPi : 2.0 * turn;
  return 1.0 + way / max_rate + kAtAHeading * plan.headings;
}

}  // namespace place_memory::core
