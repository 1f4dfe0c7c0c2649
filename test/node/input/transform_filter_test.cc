#include "node/input/transform_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

constexpr std::chrono::nanoseconds kNow = std::chrono::seconds(1000);

geometry_msgs::TransformStamped odometry(const ros::Time& stamp, double x = 0.0) {
  geometry_msgs::TransformStamped t;
  t.header.frame_id = "odom";
  t.header.stamp = stamp;
  t.child_frame_id = "base_link";
  t.transform.translation.x = x;
  t.transform.rotation.w = 1.0;
  return t;
}

void expectProblem(const geometry_msgs::TransformStamped& transform, const std::string& word) {
  const auto problem = checkTransform(transform, false, kNow);
  ASSERT_TRUE(problem) << word;
  EXPECT_NE(problem->find(word), std::string::npos) << *problem;
}

TEST(CheckTransform, TakesWhatIsStampedUpToASecondAhead) {
  for (const double stamp : {1.0, 999.0, 1000.0, 1001.0}) {
    EXPECT_FALSE(checkTransform(odometry(ros::Time(stamp)), false, kNow)) << stamp;
  }
}

TEST(CheckTransform, LeavesOutStampsThatCannotBe) {
  expectProblem(odometry(ros::Time()), "stamp is 0");
  expectProblem(odometry(ros::Time(1001, 1)), "ahead of the clock");
  expectProblem(odometry(ros::Time(1020.0)), "20.0 s ahead");
  expectProblem(odometry(ros::Time(4294967295U, 0)), "ahead of the clock");
}

TEST(CheckTransform, LeavesOutRotationsThatAreNone) {
  geometry_msgs::TransformStamped t = odometry(ros::Time(1000.0));
  t.transform.rotation.w = 0.0;
  expectProblem(t, "zeros");
  t.transform.rotation.w = std::nan("");
  expectProblem(t, "rotation is not finite");
  t.transform.rotation.w = 1e300;
  expectProblem(t, "rotation is not finite");
  t = odometry(ros::Time(1000.0), std::numeric_limits<double>::infinity());
  expectProblem(t, "translation is not finite");
  expectProblem(odometry(ros::Time(1000.0), -1e300), "further than anything lies");
  EXPECT_FALSE(checkTransform(odometry(ros::Time(1000.0), 1e7), false, kNow));
}

TEST(CheckTransform, TheStampOfAStaticTransformMeansNothing) {
  EXPECT_FALSE(checkTransform(odometry(ros::Time()), true, kNow));
  EXPECT_FALSE(checkTransform(odometry(ros::Time(4294967295U, 0)), true, kNow));
}

TEST(CheckTransform, LeavesOutNamesThatNobodyGives) {
  geometry_msgs::TransformStamped t = odometry(ros::Time(1000.0));
  t.child_frame_id = "base\nlink";
  expectProblem(t, "control characters");
  t.child_frame_id = std::string("base\0link", 9);
  expectProblem(t, "control characters");
  t.child_frame_id = std::string(300, 'b');
  expectProblem(t, "300 bytes");
}

TEST(AddTransform, EverNewFramesTakeNoMemory) {
  tf2::BufferCore buffer;
  geometry_msgs::TransformStamped t = odometry(ros::Time(1000.0));
  EXPECT_FALSE(addTransform(t, false, kNow, buffer));
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    t.child_frame_id = "frame_" + std::to_string(i);
    if (addTransform(t, false, kNow, buffer)) ++refused;
  }
  EXPECT_GT(refused, 800);
  EXPECT_LT(refused, 1000);
  // Those that are known go on.
  EXPECT_FALSE(addTransform(odometry(ros::Time(1000.1)), false, kNow, buffer));
}

TEST(AddTransform, OneFarAheadDoesNotHideThoseThatFollow) {
  tf2::BufferCore buffer;
  EXPECT_FALSE(addTransform(odometry(ros::Time(1000.0), 1.0), false, kNow, buffer));
  const auto problem = addTransform(odometry(ros::Time(1020.0), 9.0), false, kNow, buffer);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("from base_link to odom"), std::string::npos) << *problem;
  EXPECT_FALSE(addTransform(odometry(ros::Time(1000.1), 2.0), false, kNow, buffer));
  std::chrono::nanoseconds stamp{0};
  const auto newest = lookupNewest(buffer, "odom", "base_link", stamp);
  ASSERT_TRUE(newest);
  EXPECT_NEAR(newest->pose.x, 2.0, 1e-9);
}

TEST(AddTransform, NoStampOfARealClockMakesTfThrow) {
  tf2::BufferCore buffer;
  const std::chrono::nanoseconds end = std::chrono::seconds(4294967295);
  for (const std::uint32_t second : {1U, 5U, 4294967295U, 4294967290U, 7U}) {
    EXPECT_NO_THROW(addTransform(odometry(ros::Time(second, 999999999U)), false, end, buffer));
    std::string problem;
    EXPECT_NO_THROW(lookupPlanar(buffer, "odom", "base_link", std::chrono::seconds(3), problem));
    EXPECT_NO_THROW(lookupPlanar(buffer, "odom", "base_link", end, problem));
  }
}

}  // namespace
}  // namespace place_memory::node
