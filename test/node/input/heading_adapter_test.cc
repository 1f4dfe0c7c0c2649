#include "node/input/heading_adapter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "node/input/transform_filter.h"

namespace place_memory::node {
namespace {

constexpr std::chrono::nanoseconds kReceived = std::chrono::seconds(12);
constexpr double kRight = core::kPi / 2;

class HeadingAdapterTest : public testing::Test {
 protected:
  // Of a sensor that is turned to the left, and upside down or not.
  void mount(const std::string& frame, double yaw, bool upside_down = false) {
    geometry_msgs::TransformStamped t;
    t.header.frame_id = "/base_link";
    t.child_frame_id = frame;
    const double s = std::sin(0.5 * yaw), c = std::cos(0.5 * yaw);
    if (upside_down) {  // yaw, then half a turn about the new x axis
      t.transform.rotation.x = c;
      t.transform.rotation.y = s;
    } else {
      t.transform.rotation.z = s;
      t.transform.rotation.w = c;
    }
    ASSERT_FALSE(addTransform(t, true, kReceived, buffer_));
  }

  static sensor_msgs::Imu imu(double yaw, const std::string& frame = "base_link") {
    sensor_msgs::Imu m;
    m.header.stamp = ros::Time(10.0);
    m.header.frame_id = frame;
    m.orientation.z = std::sin(0.5 * yaw);
    m.orientation.w = std::cos(0.5 * yaw);
    return m;
  }

  // As a robot with that yaw feels it where magnetic north lies `declination` east of north.
  static sensor_msgs::MagneticField field(double yaw, double declination = 0.0,
                                          const std::string& frame = "base_link") {
    const double north = kRight - declination - yaw;
    sensor_msgs::MagneticField m;
    m.header.stamp = ros::Time(10.0);
    m.header.frame_id = frame;
    m.magnetic_field.x = 2e-5 * std::cos(north);
    m.magnetic_field.y = 2e-5 * std::sin(north);
    m.magnetic_field.z = -4e-5;
    return m;
  }

  static std_msgs::Float64 bearing(double degrees) {
    std_msgs::Float64 m;
    m.data = degrees;
    return m;
  }

  void expectYaw(const CheckedHeading& heading, double yaw) {
    ASSERT_FALSE(heading.problem) << *heading.problem;
    EXPECT_NEAR(core::wrapAngle(heading.yaw - yaw), 0.0, 1e-6);
  }

  config::Parameters parameters_;
  tf2::BufferCore buffer_;
  HeadingAdapter adapter_{parameters_};
};

TEST_F(HeadingAdapterTest, EveryCompassOfARobotSaysTheSame) {
  parameters_.heading.declination = 0.1;
  for (const double yaw : {-3.0, -1.0, 0.0, 0.7, 2.0}) {
    expectYaw(adapter_.adapt(imu(yaw), buffer_), yaw);
    expectYaw(adapter_.adapt(field(yaw, 0.1), buffer_), yaw);
    const double magnetic = (kRight - yaw - 0.1) * 180.0 / core::kPi;
    expectYaw(adapter_.adapt(bearing(magnetic), kReceived), yaw);
  }
}

TEST_F(HeadingAdapterTest, ABearingIsClockwiseFromNorth) {
  expectYaw(adapter_.adapt(bearing(0.0), kReceived), kRight);
  expectYaw(adapter_.adapt(bearing(90.0), kReceived), 0.0);
  expectYaw(adapter_.adapt(bearing(180.0), kReceived), -kRight);
  EXPECT_EQ(adapter_.adapt(bearing(5.0), kReceived).stamp, kReceived);
}

TEST_F(HeadingAdapterTest, OffsetAndSenseOfRotationAreParameters) {
  parameters_.heading.yaw_offset = 0.3;
  expectYaw(adapter_.adapt(imu(1.0), buffer_), 1.3);
  parameters_.heading.reversed = true;
  expectYaw(adapter_.adapt(imu(1.0), buffer_), -0.7);
  expectYaw(adapter_.adapt(bearing(90.0), kReceived), core::kPi + 0.3);
}

TEST_F(HeadingAdapterTest, TheMountOfACompassIsThatOfTf) {
  mount("turned", 1.2);
  mount("hanging", 0.4, true);
  expectYaw(adapter_.adapt(imu(0.5 + 1.2, "/turned"), buffer_), 0.5);
  expectYaw(adapter_.adapt(field(0.5 + 1.2, 0.0, "turned"), buffer_), 0.5);
  sensor_msgs::Imu hanging = imu(0.0, "hanging");
  const double yaw = 0.5 + 0.4;
  hanging.orientation.x = std::cos(0.5 * yaw);
  hanging.orientation.y = std::sin(0.5 * yaw);
  hanging.orientation.z = hanging.orientation.w = 0.0;
  expectYaw(adapter_.adapt(hanging, buffer_), 0.5);
  EXPECT_EQ(adapter_.frameProblem(), "");
}

TEST_F(HeadingAdapterTest, AFrameThatTfDoesNotKnowIsNamedWithThoseItKnows) {
  mount("turned", 1.2);
  for (int i = 0; i < 30; ++i) expectYaw(adapter_.adapt(imu(0.5, "ghost"), buffer_), 0.5);
  EXPECT_NE(adapter_.frameProblem().find("ghost"), std::string::npos);
  EXPECT_NE(adapter_.frameProblem().find("base_link, turned"), std::string::npos)
      << adapter_.frameProblem();
}

TEST_F(HeadingAdapterTest, WhatIsNoHeadingIsNamed) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf, 1e6}) {
    EXPECT_TRUE(adapter_.adapt(bearing(bad), kReceived).problem) << bad;
  }
  sensor_msgs::MagneticField m = field(0.0);
  m.magnetic_field.x = m.magnetic_field.y = 0.0;
  EXPECT_TRUE(adapter_.adapt(m, buffer_).problem) << "straight down";
  m.magnetic_field.z = 0.0;
  EXPECT_TRUE(adapter_.adapt(m, buffer_).problem) << "none";
  m.magnetic_field.x = std::nan("");
  EXPECT_TRUE(adapter_.adapt(m, buffer_).problem);
  m = field(0.0);
  m.header.stamp = ros::Time();
  EXPECT_TRUE(adapter_.adapt(m, buffer_).problem);
}

}  // namespace
}  // namespace place_memory::node
