#include "node/drive/drive_feed.h"

#include <utility>
#include <variant>

#include "node/base/ros_time.h"
#include "node/input/transform_filter.h"

namespace place_memory::node {
namespace {

using std::chrono::nanoseconds;

// Transforms are remembered for so long: no reading waits longer for those around its stamp.
const ros::Duration kRemembered(30.0);

}  // namespace

DriveMoment momentOf(const geometry_msgs::TransformStamped& transform, nanoseconds received) {
  return {toNanoseconds(transform.header.stamp), DrivenTransform{transform, received}};
}

std::vector<DriveMoment> momentsOf(Taken taken, nanoseconds received, DriveLosses& losses) {
  std::vector<DriveMoment> moments;
  for (const auto& transform : taken.transforms) moments.push_back(momentOf(transform, received));
  for (const CheckedHeading& heading : taken.headings) {
    if (!heading.problem) moments.push_back({heading.stamp, DrivenHeading{heading.yaw}});
  }
  for (AdaptedReading& reading : taken.readings) {
    if (reading.measurement.stamp.count() == 0) reading.reject = Reject::kNoStamp;
    if (reading.reject) {
      ++losses.rejected[static_cast<std::size_t>(*reading.reject)];
      if (!reading.sensor_problem.empty()) losses.problem = reading.sensor_problem;
      continue;
    }
    const nanoseconds stamp = reading.measurement.stamp;
    moments.push_back({stamp, std::move(reading.measurement)});
  }
  for (const Taken::Problem& problem : taken.problems) losses.problem = problem.sentence;
  return moments;
}

DriveFeed::DriveFeed(const config::Parameters& parameters, DriveLosses& losses,
                     DriveListener& listener)
    : wait_(toNanoseconds(parameters.scan.tf_timeout)),
      transforms_(kRemembered),
      headings_(std::chrono::seconds(1)),
      locator_(parameters, transforms_, headings_),
      losses_(losses),
      listener_(listener) {}

void DriveFeed::addStatic(const geometry_msgs::TransformStamped& transform) {
  note(addTransform(transform, true, nanoseconds(0), transforms_));
}

void DriveFeed::take(const DriveMoment& moment) {
  std::visit([&](const auto& what) { take(moment.stamp, what); }, moment.what);
}

void DriveFeed::take(nanoseconds stamp, const DrivenHeading& heading) {
  listener_.onHeading(stamp, heading.yaw);
}

void DriveFeed::take(nanoseconds /*stamp*/, const core::Measurement& measurement) {
  waiting_.push_back(measurement);
}

void DriveFeed::take(nanoseconds /*stamp*/, const DrivenTransform& moved) {
  note(addTransform(moved.transform, false, moved.received, transforms_));
  const auto newest = locator_.newestBase();
  if (!newest || (odometry_ && newest->stamp <= *odometry_)) return;
  odometry_ = newest->stamp;
  release(newest->stamp);
  listener_.onOdometry(newest->stamp, newest->pose);
}

void DriveFeed::end() {
  for (const core::Measurement& measurement : waiting_) reject(locator_.locate(measurement));
  waiting_.clear();
}

void DriveFeed::restart() {
  end();
  transforms_.clear();
  odometry_.reset();
}

void DriveFeed::note(const std::optional<std::string>& problem) {
  if (problem) losses_.problem = *problem;
}

void DriveFeed::reject(const ReadingLocator::Located& located) {
  const auto why = located.reject ? *located.reject : Reject::kNoOdometry;
  ++losses_.rejected[static_cast<std::size_t>(why)];
  if (!located.problem.empty()) losses_.problem = located.problem;
}

// In their order: where the transform of a sensor is late, those behind it wait as well.
void DriveFeed::release(nanoseconds until) {
  for (; !waiting_.empty() && waiting_.front().stamp <= until; waiting_.pop_front()) {
    const core::Measurement& measurement = waiting_.front();
    const auto located = locator_.locate(measurement);
    if (!located.reject) {
      core::SonarReading reading = located.reading.reading;
      const core::Pose2d& base = located.reading.fixed_from_base;
      reading.sensor_pose = base.inverse() * reading.sensor_pose;
      ++losses_.readings;
      listener_.onReading(measurement.stamp, base, reading);
    } else if (ReadingLocator::mayCome(*located.reject) && until - measurement.stamp < wait_) {
      return;
    } else {
      reject(located);
    }
  }
}

}  // namespace place_memory::node
