#include "tools/drive_reader.h"

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/Range.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <deque>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "core/sensing/heading_history.h"
#include "node/base/ros_time.h"
#include "node/input/heading_check.h"
#include "node/input/range_adapter.h"
#include "node/input/transform_filter.h"
#include "node/scan/reading_locator.h"
#include "tools/bag_file.h"

namespace place_memory::tools {
namespace {

using std::chrono::nanoseconds;

// Transforms are remembered for so long: no reading waits longer for those around its stamp.
const ros::Duration kRemembered(30.0);

// Names are the same with and without the slash: a bag has them resolved, parameters do not.
std::string withoutSlash(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

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

/// Everything of a bag that a drive consists of.
class BagContents {
 public:
  BagContents(const std::string& path, const config::Parameters& parameters)
      : parameters_(parameters) {
    openBag(path, bag_);
    requireTopics(path);
    rosbag::View view(bag_);
    for (const rosbag::MessageInstance& message : view) take(message);
    std::stable_sort(moments.begin(), moments.end());
  }

  std::vector<Moment> moments;
  std::vector<geometry_msgs::TransformStamped> static_transforms;
  DriveLosses losses;

 private:
  void requireTopics(const std::string& path) {
    std::map<std::string, std::string> types;
    rosbag::View everything(bag_);
    for (const rosbag::ConnectionInfo* connection : everything.getConnections()) {
      types[withoutSlash(connection->topic)] = connection->datatype;
    }
    const auto require = [&](const std::string& topic, const std::string& type) {
      const auto found = types.find(withoutSlash(topic));
      if (found == types.end()) {
        throw std::runtime_error("the bag " + path + " has no topic " + topic);
      }
      if (found->second != type) {
        throw std::runtime_error("in the bag " + path + " the topic " + topic + " holds " +
                                 found->second + ", not " + type);
      }
    };
    for (const std::string& topic : parameters_.sonar_topics) {
      require(topic, "sensor_msgs/Range");
      sonar_topics_.push_back(withoutSlash(topic));
    }
    heading_topic_ = withoutSlash(parameters_.heading_topic);
    if (!heading_topic_.empty()) require(heading_topic_, "sensor_msgs/Imu");
    require("tf", "tf2_msgs/TFMessage");
  }

  void take(const rosbag::MessageInstance& message) {
    const std::string topic = withoutSlash(message.getTopic());
    const nanoseconds received = node::toNanoseconds(message.getTime());
    if (topic == "tf" || topic == "tf_static") {
      const auto moved = message.instantiate<tf2_msgs::TFMessage>();
      if (!moved) return;
      for (const auto& transform : moved->transforms) {
        if (topic == "tf_static") {
          static_transforms.push_back(transform);
        } else {
          const nanoseconds stamp = node::toNanoseconds(transform.header.stamp);
          moments.push_back({stamp, Moved{transform, received}});
        }
      }
    } else if (!heading_topic_.empty() && topic == heading_topic_) {
      const auto imu = message.instantiate<sensor_msgs::Imu>();
      if (!imu || imu->header.stamp.isZero()) return;
      const node::CheckedHeading heading = node::checkHeading(*imu);
      if (heading.problem) return;
      moments.push_back({node::toNanoseconds(imu->header.stamp), Heading{heading.yaw}});
    } else if (std::count(sonar_topics_.begin(), sonar_topics_.end(), topic) > 0) {
      const auto range = message.instantiate<sensor_msgs::Range>();
      if (range) takeReading(message.getTopic(), *range);
    }
  }

  void takeReading(const std::string& topic, const sensor_msgs::Range& range) {
    const node::RangeAdapter adapter(topic, parameters_.scan.over_range_is_no_echo, registry_);
    node::AdaptedReading adapted = adapter.adapt(range);
    if (range.header.stamp.isZero()) adapted.reject = node::Reject::kNoStamp;
    if (adapted.reject) {
      ++losses.rejected[static_cast<std::size_t>(*adapted.reject)];
      if (!adapted.sensor_problem.empty()) losses.problem = adapted.sensor_problem;
      return;
    }
    const nanoseconds stamp = adapted.measurement.stamp;
    moments.push_back({stamp, std::move(adapted.measurement)});
  }

  const config::Parameters& parameters_;
  rosbag::Bag bag_;
  std::vector<std::string> sonar_topics_;
  std::string heading_topic_;
  node::SensorRegistry registry_;
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

DriveLosses readDrive(const std::string& path, const config::Parameters& parameters,
                      DriveListener& listener) {
  if (parameters.odom_frame.empty()) {
    throw std::runtime_error(
        "a drive needs odometry, but odom_frame is empty: name the frame in which the robot's "
        "odometry gives " +
        parameters.base_frame);
  }
  BagContents contents(path, parameters);
  DriveFeed feed(parameters, contents.losses, listener);
  for (const auto& transform : contents.static_transforms) feed.addStatic(transform);
  for (const Moment& moment : contents.moments) {
    std::visit([&](const auto& what) { feed(moment.stamp, what); }, moment.what);
  }
  feed.end();
  return contents.losses;
}

}  // namespace place_memory::tools
