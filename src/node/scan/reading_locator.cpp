#include "node/scan/reading_locator.h"

#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

// A sonar that looks up or down more steeply says nothing about the plane.
constexpr double kLeastLevel = 0.1;

}  // namespace

bool ReadingLocator::mayCome(Reject reject) {
  return reject == Reject::kNoTransform || reject == Reject::kNoOdometry ||
         reject == Reject::kNoHeading;
}

std::optional<core::Pose2d> ReadingLocator::baseAt(std::chrono::nanoseconds stamp,
                                                   std::string& problem) const {
  if (usesOdometry()) {
    const auto base =
        lookupPlanar(buffer_, parameters_.odom_frame, parameters_.base_frame, stamp, problem);
    if (!base) return std::nullopt;
    return base->pose;
  }
  const std::optional<double> heading = headings_.at(stamp);
  if (!heading) {
    problem = "no heading on " + parameters_.heading_topic + " near the stamp of a reading";
    return std::nullopt;
  }
  return core::Pose2d{0.0, 0.0, *heading};
}

std::optional<ReadingLocator::NewestBase> ReadingLocator::newestBase() const {
  if (!usesOdometry()) {
    const auto newest = headings_.newest();
    if (!newest) return std::nullopt;
    return NewestBase{newest->stamp, {0.0, 0.0, newest->yaw}};
  }
  NewestBase newest;
  const auto base =
      lookupNewest(buffer_, parameters_.odom_frame, parameters_.base_frame, newest.stamp);
  if (!base) return std::nullopt;
  newest.pose = base->pose;
  return newest;
}

ReadingLocator::Located ReadingLocator::locate(const core::Measurement& measurement) const {
  Located located;
  const auto frame = lookupPlanar(buffer_, parameters_.base_frame, measurement.frame,
                                  measurement.stamp, located.problem);
  if (!frame) {
    located.reject = Reject::kNoTransform;
    return located;
  }
  if (frame->level < kLeastLevel) {
    located.reject = Reject::kVertical;
    return located;
  }
  const auto base = baseAt(measurement.stamp, located.problem);
  if (!base) {
    located.reject = usesOdometry() ? Reject::kNoOdometry : Reject::kNoHeading;
    return located;
  }
  core::LocatedReading& reading = located.reading;
  reading.stamp = measurement.stamp;
  reading.sensor = measurement.sensor;
  reading.fixed_from_base = *base;
  core::Pose2d frame_from_sensor = measurement.frame_from_sensor;
  if (frame->upside_down) {
    frame_from_sensor = {frame_from_sensor.x, -frame_from_sensor.y, -frame_from_sensor.yaw};
  }
  reading.reading.sensor_pose = *base * frame->pose * frame_from_sensor;
  reading.reading.spec = measurement.spec;
  reading.reading.spec.min_range *= frame->level;
  reading.reading.spec.max_range *= frame->level;
  reading.reading.range = measurement.range * frame->level;
  return located;
}

}  // namespace place_memory::node
