#include "node/input/heading_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace place_memory::node {
namespace {

sensor_msgs::Imu message(double x, double y, double z, double w) {
  sensor_msgs::Imu m;
  m.header.stamp = ros::Time(10.0);
  m.orientation.x = x;
  m.orientation.y = y;
  m.orientation.z = z;
  m.orientation.w = w;
  return m;
}

TEST(CheckHeading, GivesTheYaw) {
  for (const double yaw : {-3.0, -0.5, 0.0, 1.2, 3.1}) {
    const auto heading = checkHeading(message(0, 0, std::sin(yaw / 2), std::cos(yaw / 2)));
    ASSERT_FALSE(heading.problem);
    EXPECT_NEAR(heading.yaw, yaw, 1e-12);
  }
}

TEST(CheckHeading, GivesTheYawOfATiltedRobot) {
  // Yaw 0.7, then pitch 0.3.
  const double sy = std::sin(0.35), cy = std::cos(0.35), sp = std::sin(0.15), cp = std::cos(0.15);
  const auto heading = checkHeading(message(-sy * sp, cy * sp, sy * cp, cy * cp));
  ASSERT_FALSE(heading.problem);
  EXPECT_NEAR(heading.yaw, 0.7, 1e-12);
}

TEST(CheckHeading, NormalisesAQuaternionThatIsSlightlyOff) {
  const double yaw = 1.0;
  const auto heading =
      checkHeading(message(0, 0, 1.05 * std::sin(yaw / 2), 1.05 * std::cos(yaw / 2)));
  ASSERT_FALSE(heading.problem);
  EXPECT_NEAR(heading.yaw, yaw, 1e-12);
}

struct BadQuaternion {
  const char* what;
  double x, y, z, w;
};

std::ostream& operator<<(std::ostream& out, const BadQuaternion& bad) { return out << bad.what; }

class BadHeading : public testing::TestWithParam<BadQuaternion> {};

TEST_P(BadHeading, IsLeftOut) {
  const BadQuaternion& q = GetParam();
  EXPECT_TRUE(checkHeading(message(q.x, q.y, q.z, q.w)).problem);
}

constexpr double kInf = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(
    CheckHeading, BadHeading,
    testing::Values(BadQuaternion{"zero", 0, 0, 0, 0}, BadQuaternion{"NaN", 0, 0, std::nan(""), 1},
                    BadQuaternion{"infinite", 0, 0, kInf, 1},
                    BadQuaternion{"overflows", 0, 0, 1e300, 1}, BadQuaternion{"half", 0, 0, 0, 0.5},
                    BadQuaternion{"double", 0, 0, 0, 2},
                    BadQuaternion{"x axis up", 0, -std::sqrt(0.5), 0, std::sqrt(0.5)}));

TEST(CheckHeading, LeavesOutAMessageWithoutOrientation) {
  sensor_msgs::Imu m = message(0, 0, 0, 1);
  m.orientation_covariance[0] = -1.0;
  EXPECT_TRUE(checkHeading(m).problem);
}

TEST(CheckHeading, LeavesOutAMessageWithoutAStamp) {
  sensor_msgs::Imu m = message(0, 0, 0, 1);
  m.header.stamp = ros::Time();
  EXPECT_TRUE(checkHeading(m).problem);
}

}  // namespace
}  // namespace place_memory::node
