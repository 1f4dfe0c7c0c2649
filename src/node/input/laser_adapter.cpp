#include "node/input/laser_adapter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "node/base/ros_time.h"
#include "node/input/echo_dialect.h"
#include "node/input/frame_name.h"
#include "node/input/range_check.h"

namespace place_memory::node {
namespace {

constexpr std::size_t kMostBeams = 100000;
constexpr double kOnceAround = 2.0 * core::kPi * 1.01;
// Drivers round angle_max.
constexpr double kCountSlack = 0.02;

// What is wrong with the fan; empty: nothing.
std::string checkFan(const sensor_msgs::LaserScan& scan) {
  const auto beams = static_cast<double>(scan.ranges.size());
  std::ostringstream problem;
  if (scan.ranges.empty() || scan.ranges.size() > kMostBeams) {
    problem << "ranges holds " << scan.ranges.size() << " beams, not 1 to " << kMostBeams;
  } else if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_max)) {
    problem << "angle_min and angle_max must be finite, not " << scan.angle_min << " and "
            << scan.angle_max;
  } else if (!std::isfinite(scan.angle_increment) || scan.angle_increment == 0.0F) {
    problem << "angle_increment must be finite and not 0, not " << scan.angle_increment;
  } else if (std::abs(scan.angle_increment) * (beams - 1.0) > kOnceAround) {
    problem << "its beams go further than once around: is angle_increment (" << scan.angle_increment
            << ") in degrees?";
  } else {
    const double said =
        (double{scan.angle_max} - double{scan.angle_min}) / scan.angle_increment + 1.0;
    if (std::abs(said - beams) > 1.5 + kCountSlack * beams) {
      problem << "ranges holds " << scan.ranges.size() << " beams, but the angles say "
              << std::lround(std::clamp(said, -1e9, 1e9));
    }
  }
  return problem.str();
}

double angleOf(const sensor_msgs::LaserScan& scan, double beam) {
  return double{scan.angle_min} + beam * double{scan.angle_increment};
}

}  // namespace

std::vector<AdaptedReading> LaserAdapter::adapt(const sensor_msgs::LaserScan& scan) const {
  AdaptedReading adapted;
  core::Measurement& measurement = adapted.measurement;
  measurement.stamp = toNanoseconds(scan.header.stamp);
  measurement.frame = frameName(scan.header.frame_id, adapted.sensor_problem);
  measurement.sensor = registry_->idOf(topic_, measurement.frame);
  if (adapted.sensor_problem.empty()) {
    adapted.sensor_problem =
        measurement.frame.empty() ? "header.frame_id is empty" : checkFan(scan);
  }
  const std::size_t beams = scan.ranges.size();
  const std::size_t cones = std::min(static_cast<std::size_t>(parameters_->laser.cones), beams);
  if (adapted.sensor_problem.empty()) {
    const double wide = std::abs(double{scan.angle_increment}) * static_cast<double>(beams) /
                        static_cast<double>(cones);
    measurement.spec = {std::min(wide, core::kPi), scan.range_min, scan.range_max};
    adapted.sensor_problem = checkSpec(measurement.spec).value_or("");
  }
  if (!adapted.sensor_problem.empty()) {
    adapted.reject = Reject::kBadSensor;
  } else if (scan.header.stamp.isZero()) {
    adapted.reject = Reject::kNoStamp;
  }
  if (adapted.reject) return {adapted};
  std::vector<AdaptedReading> readings;
  for (std::size_t cone = 0; cone < cones; ++cone) {
    const std::size_t first = cone * beams / cones;
    const std::size_t last = (cone + 1) * beams / cones;
    measure(scan, first, last, readings.emplace_back(adapted));
  }
  return readings;
}

void LaserAdapter::measure(const sensor_msgs::LaserScan& scan, std::size_t first, std::size_t last,
                           AdaptedReading& reading) const {
  core::Measurement& measurement = reading.measurement;
  const double middle = 0.5 * static_cast<double>(first + last - 1);
  measurement.frame_from_sensor = {0.0, 0.0, angleOf(scan, middle)};
  measurement.range = std::numeric_limits<double>::infinity();
  bool heard = false;
  for (std::size_t beam = first; beam < last; ++beam) {
    double range = scan.ranges[beam];
    // Each beam for itself: what repeats in a fan says nothing.
    const auto no_echo =
        EchoDialect().noEcho(measurement.stamp, range, measurement.spec, parameters_->no_echo);
    if (no_echo) {
      reading.no_echo = NoEchoWord{range, *no_echo};
      range = std::numeric_limits<double>::infinity();
    }
    const CheckedRange checked = checkRange(measurement.spec, range, parameters_->scan);
    if (checked.reject) {
      if (!heard && !reading.reject) reading.reject = checked.reject;
      continue;
    }
    heard = true;
    measurement.range = std::min(measurement.range, checked.range);
  }
  if (heard) reading.reject.reset();
}

}  // namespace place_memory::node
