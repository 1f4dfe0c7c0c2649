#ifndef PLACE_MEMORY_TEST_NODE_SCAN_SCAN_COLLECTOR_FIXTURE_H
#define PLACE_MEMORY_TEST_NODE_SCAN_SCAN_COLLECTOR_FIXTURE_H

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "node/base/ros_time.h"
#include "node/input/range_adapter.h"
#include "node/scan/scan_collector.h"

namespace place_memory::node {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kStart = 100.0;  // [s]
constexpr double kStep = core::kPi / 90.0;
constexpr int kSensors = 4;

inline geometry_msgs::TransformStamped transform(const std::string& parent,
                                                 const std::string& child, const core::Pose2d& pose,
                                                 double stamp) {
  geometry_msgs::TransformStamped t;
  t.header.frame_id = parent;
  t.header.stamp = ros::Time(stamp);
  t.child_frame_id = child;
  t.transform.translation.x = pose.x;
  t.transform.translation.y = pose.y;
  t.transform.rotation.z = std::sin(pose.yaw / 2);
  t.transform.rotation.w = std::cos(pose.yaw / 2);
  return t;
}

inline core::Pose2d mounting(int sensor) {
  const double bearing = sensor * core::kPi / 2;
  return core::Pose2d{0, 0, bearing} * core::Pose2d{0.2, 0, 0};
}

inline std::string frame(int sensor) { return "sonar_" + std::to_string(sensor); }

// A robot with four sonars that turns on the spot; odometry, compass and tf are as it publishes
// them.
class ScanCollectorTest : public testing::Test {
 protected:
  ScanCollectorTest() {
    parameters_.scan.min_readings = 4;
    for (int k = 0; k < kSensors; ++k) {
      buffer_.setTransform(transform("base_link", frame(k), mounting(k), kStart), "test", true);
    }
  }

  ScanCollector& collector() {
    if (!collector_) collector_.emplace(parameters_, buffer_, registry_);
    return *collector_;
  }

  void begin(int headings = 11) { collector().begin(toNanoseconds(kStart), headings, kStep); }

  void odometry(double stamp, const core::Pose2d& pose) {
    buffer_.setTransform(transform("odom", "base_link", pose, stamp), "test");
  }

  void heading(double stamp, double yaw) {
    sensor_msgs::Imu m;
    m.header.stamp = ros::Time(stamp);
    m.orientation.z = std::sin(yaw / 2);
    m.orientation.w = std::cos(yaw / 2);
    addHeading(m, stamp);
  }

  void range(double stamp, int sensor, double value) {
    rangeReceived(stamp, frame(sensor), value, stamp);
  }

  void rangeReceived(double stamp, const std::string& frame_id, double value, double received) {
    sensor_msgs::Range m;
    m.header.stamp = ros::Time(stamp);
    m.header.frame_id = frame_id;
    m.field_of_view = 0.4F;
    m.min_range = 0.1F;
    m.max_range = 4.0F;
    m.range = static_cast<float>(value);
    addRange(m, received);
  }

  void addHeading(const sensor_msgs::Imu& message, double received) {
    collector().addHeading(checkHeading(message), toNanoseconds(received));
  }

  void addRange(const sensor_msgs::Range& message, double received) {
    RangeAdapter adapter("/sonar", parameters_, registry_);
    collector().addReading(adapter.adapt(message), toNanoseconds(received));
  }

  SensorHealth health(const std::string& name) {
    for (const SensorHealth& sensor : collector().sensorHealth()) {
      if (sensor.name == name) return sensor;
    }
    ADD_FAILURE() << "no sensor " << name;
    return {};
  }

  void process(double now) { collector().process(toNanoseconds(now)); }

  ScanOutcome outcomeAfter(double seconds) {
    process(kStart + seconds);
    return collector().outcome(toNanoseconds(kStart + seconds));
  }

  // The robot turns at 0.2 rad/s from a yaw while its sensors fire in turn; the compass reads
  // `compass_error` more than odometry.
  void turnAndSense(double yaw, double compass_error, double seconds = 2.0) {
    const auto yawAt = [&](double t) { return yaw + 0.2 * t; };
    for (int i = 0; i * 0.1 < seconds + 0.2; ++i) {
      const double t = i * 0.1;
      odometry(kStart + t, {3.0, -1.0, yawAt(t)});
      heading(kStart + t, yawAt(t) + compass_error);
    }
    for (int i = 0; i * 0.05 < seconds; ++i) {
      range(kStart + 0.02 + i * 0.05, i % kSensors, i % 5 == 0 ? kInf : 1.0 + 0.1 * (i % 7));
    }
  }

  config::Parameters parameters_;
  tf2::BufferCore buffer_{ros::Duration(1000.0)};
  SensorRegistry registry_;
  std::optional<ScanCollector> collector_;
};

inline std::uint32_t count(const ScanCollector& collector, Reject reject) {
  return collector.rejected().at(static_cast<std::size_t>(reject));
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_TEST_NODE_SCAN_SCAN_COLLECTOR_FIXTURE_H
