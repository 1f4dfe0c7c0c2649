#include "tools/drive_reader.h"

#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "core/sensing/heading_history.h"
#include "node/base/ros_time.h"
#include "node/input/transform_filter.h"
#include "node/scan/reading_locator.h"

namespace place_memory::tools {
namespace {

using std::chrono::nanoseconds;

// Transforms are remembered for so long: no reading waits longer for those around its stamp.
const ros::Duration kRemembered(30.0);

struct Heading {
  double yaw = 0.0;
};

struct Moved {
  geometry_msgs::TransformStamped transform;
  nanoseconds received{0};
};

/// A message, by the stamp in it. Of one stamp the transforms come last: all that is known of a
/// moment is there when odometry has come to it. What else has one stamp is ordered by its frame,
/// and not by which was recorded first.
struct Moment {
  nanoseconds stamp{0};
  std::variant<Heading, core::Measurement, Moved> what;

  const std::string& frame() const {
    static const std::string kNone;
    if (const auto* measurement = std::get_if<core::Measurement>(&what)) return measurement->frame;
    if (const auto* moved = std::get_if<Moved>(&what)) return moved->transform.child_frame_id;
    return kNone;
  }

  bool operator<(const Moment& other) const {
    const std::size_t kind = what.index(), other_kind = other.what.index();
    return std::tie(stamp, kind, frame()) < std::tie(other.stamp, other_kind, other.frame());
  }
};

/// Everything of the bags that a drive consists of.
class BagContents {
 public:
  BagContents(const BagSet& bags, BagScanner& scanner) : scanner_(scanner) {
    for (const auto& transform : scanner.staticTransforms()) {
      node::addTransform(transform, true, nanoseconds(0), mounts_);
    }
    bags.read(scanner.topics(), bags.first(), bags.last(),
              [this](const TimedMessage& timed) { take(timed); });
    std::stable_sort(moments.begin(), moments.end());
  }

  std::vector<Moment> moments;
  DriveLosses losses;

 private:
  void take(const TimedMessage& timed) {
    const nanoseconds received = node::toNanoseconds(timed.time);
    if (const auto moved = timed.message->as<tf2_msgs::TFMessage>()) {
      for (const auto& transform : moved->transforms) take(transform, received);
      return;
    }
    node::Taken taken = scanner_.take(timed, mounts_);
    for (const auto& transform : taken.transforms) take(transform, received);
    for (const node::CheckedHeading& heading : taken.headings) {
      if (!heading.problem) moments.push_back({heading.stamp, Heading{heading.yaw}});
    }
    for (node::AdaptedReading& reading : taken.readings) take(reading);
    for (const node::Taken::Problem& problem : taken.problems) losses.problem = problem.sentence;
  }

  void take(const geometry_msgs::TransformStamped& transform, nanoseconds received) {
    moments.push_back({node::toNanoseconds(transform.header.stamp), Moved{transform, received}});
  }

  void take(node::AdaptedReading& reading) {
    if (reading.measurement.stamp.count() == 0) reading.reject = node::Reject::kNoStamp;
    if (reading.reject) {
      ++losses.rejected[static_cast<std::size_t>(*reading.reject)];
      if (!reading.sensor_problem.empty()) losses.problem = reading.sensor_problem;
      return;
    }
    const nanoseconds stamp = reading.measurement.stamp;
    moments.push_back({stamp, std::move(reading.measurement)});
  }

  BagScanner& scanner_;
  tf2::BufferCore mounts_;  // of compasses
};

/// Locates readings and hands everything on.
class DriveFeed {
 public:
  DriveFeed(const config::Parameters& parameters, DriveLosses& losses, DriveListener& listener)
      : wait_(static_cast<std::int64_t>(parameters.scan.tf_timeout * 1e9)),
        transforms_(kRemembered),
        headings_(std::chrono::seconds(1)),
        locator_(parameters, transforms_, headings_),
        losses_(losses),
        listener_(listener) {}

  void addStatic(const geometry_msgs::TransformStamped& transform) {
    note(node::addTransform(transform, true, nanoseconds(0), transforms_));
  }

  void operator()(nanoseconds stamp, const Heading& heading) {
    listener_.onHeading(stamp, heading.yaw);
  }

  void operator()(nanoseconds /*stamp*/, const core::Measurement& measurement) {
    waiting_.push_back(measurement);
  }

  void operator()(nanoseconds /*stamp*/, const Moved& moved) {
    note(node::addTransform(moved.transform, false, moved.received, transforms_));
    const auto newest = locator_.newestBase();
    if (!newest || (odometry_ && newest->stamp <= *odometry_)) return;
    odometry_ = newest->stamp;
    release(newest->stamp);
    listener_.onOdometry(newest->stamp, newest->pose);
  }

  /// Those still without odometry after their stamp are lost.
  void end() {
    for (const core::Measurement& measurement : waiting_) reject(locator_.locate(measurement));
  }

 private:
  void note(const std::optional<std::string>& problem) {
    if (problem) losses_.problem = *problem;
  }

  void reject(const node::ReadingLocator::Located& located) {
    const auto why = located.reject ? *located.reject : node::Reject::kNoOdometry;
    ++losses_.rejected[static_cast<std::size_t>(why)];
    if (!located.problem.empty()) losses_.problem = located.problem;
  }

  // In their order: where the transform of a sensor is late, those behind it wait as well.
  void release(nanoseconds until) {
    for (; !waiting_.empty() && waiting_.front().stamp <= until; waiting_.pop_front()) {
      const core::Measurement& measurement = waiting_.front();
      const auto located = locator_.locate(measurement);
      if (!located.reject) {
        core::SonarReading reading = located.reading.reading;
        const core::Pose2d& base = located.reading.fixed_from_base;
        reading.sensor_pose = base.inverse() * reading.sensor_pose;
        ++losses_.readings;
        listener_.onReading(measurement.stamp, base, reading);
      } else if (node::ReadingLocator::mayCome(*located.reject) &&
                 until - measurement.stamp < wait_) {
        return;
      } else {
        reject(located);
      }
    }
  }

  nanoseconds wait_;
  tf2::BufferCore transforms_;
  core::HeadingHistory headings_;  // there is odometry
  node::ReadingLocator locator_;
  DriveLosses& losses_;
  DriveListener& listener_;
  std::deque<core::Measurement> waiting_;
  std::optional<nanoseconds> odometry_;
};

}  // namespace

DriveLosses readDrive(const BagSet& bags, BagScanner& scanner, const config::Parameters& parameters,
                      DriveListener& listener) {
  if (parameters.odom_frame.empty()) {
    throw std::runtime_error(
        "a drive needs odometry, but odom_frame is empty: name the frame in which the robot's "
        "odometry gives " +
        parameters.base_frame);
  }
  BagContents contents(bags, scanner);
  DriveFeed feed(parameters, contents.losses, listener);
  for (const auto& transform : scanner.staticTransforms()) feed.addStatic(transform);
  for (const Moment& moment : contents.moments) {
    std::visit([&](const auto& what) { feed(moment.stamp, what); }, moment.what);
  }
  feed.end();
  return contents.losses;
}

}  // namespace place_memory::tools
