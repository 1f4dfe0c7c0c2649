#include "node/base/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

using core::kGridSize;

double yawOf(const geometry_msgs::Quaternion& orientation) {
  return 2.0 * std::atan2(orientation.z, orientation.w);
}

const std_msgs::Header kHeader = makeHeader("map", ros::Time(7, 8));

TEST(ToRosTime, KeepsNanoseconds) {
  EXPECT_EQ(toRosTime(std::chrono::nanoseconds(1500000000000000007)), ros::Time(1500000000, 7));
}

TEST(ToRosTime, StaysWithinWhatAMessageHolds) {
  EXPECT_EQ(toRosTime(std::chrono::nanoseconds::min()), ros::Time(0, 0));
  EXPECT_EQ(toRosTime(std::chrono::nanoseconds::max()).sec,
            std::numeric_limits<std::uint32_t>::max());
}

TEST(ToOccupancyGrid, TellsUnsensedFromSensedCells) {
  core::EvidenceGrid grid;
  grid.add(0, 1, 127);
  grid.add(1, 0, -127);
  grid.add(63, 63, 16);
  const nav_msgs::OccupancyGrid message = toOccupancyGrid(grid, {}, kHeader, 0.5);
  ASSERT_EQ(message.data.size(), std::size_t{kGridSize * kGridSize});
  EXPECT_EQ(message.data[0], -1);
  EXPECT_EQ(message.data[1], 100);
  EXPECT_EQ(message.data[kGridSize], 0);
  EXPECT_EQ(message.data[kGridSize * kGridSize - 1], 73);  // 1 / (1 + 1 / e)
}

TEST(ToOccupancyGrid, EveryEvidenceIsAPercentageThatRises) {
  for (const double prior : {0.01, 0.5, 0.99}) {
    int last = 0;
    for (int evidence = -127; evidence <= 127; ++evidence) {
      if (evidence == 0) continue;
      core::EvidenceGrid grid;
      grid.add(5, 5, evidence);
      const int value = toOccupancyGrid(grid, {}, kHeader, prior).data[5 * kGridSize + 5];
      EXPECT_GE(value, last);
      EXPECT_LE(value, 100);
      last = value;
    }
  }
}

TEST(ToOccupancyGrid, PutsTheOriginInTheCornerOfTheFirstCell) {
  const core::EvidenceGrid grid(core::GridGeometry{0.1});
  const nav_msgs::OccupancyGrid message =
      toOccupancyGrid(grid, {10.0, 20.0, core::kPi / 2.0}, kHeader, 0.5);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(7, 8));
  EXPECT_FLOAT_EQ(message.info.resolution, 0.1F);
  EXPECT_EQ(message.info.width, 64U);
  EXPECT_EQ(message.info.height, 64U);
  // A quarter turn takes the corner at (-3.2, -3.2) to (3.2, -3.2).
  EXPECT_NEAR(message.info.origin.position.x, 13.2, 1e-9);
  EXPECT_NEAR(message.info.origin.position.y, 16.8, 1e-9);
  EXPECT_NEAR(yawOf(message.info.origin.orientation), core::kPi / 2.0, 1e-9);
}

TEST(ToPoseWithCovariance, PutsThreeByThreeIntoSixBySix) {
  const geometry_msgs::PoseWithCovariance message =
      toPoseWithCovariance({1.0, 2.0, -0.5}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_EQ(message.pose.position.x, 1.0);
  EXPECT_EQ(message.pose.position.y, 2.0);
  EXPECT_NEAR(yawOf(message.pose.orientation), -0.5, 1e-12);
  const std::map<std::size_t, double> expected{{0, 1},  {1, 2},  {5, 3},  {6, 4}, {7, 5},
                                               {11, 6}, {30, 7}, {31, 8}, {35, 9}};
  for (std::size_t i = 0; i < message.covariance.size(); ++i) {
    const auto found = expected.find(i);
    EXPECT_EQ(message.covariance[i], found == expected.end() ? 0.0 : found->second) << i;
  }
}

TEST(ToMessage, ARecognitionKeepsEveryMatchInOrder) {
  core::PlaceMemory::Answer answer;
  answer.recognition.verdict = core::Verdict::kAmbiguous;
  answer.recognition.matches = {{5, 90.0, {0.1, 0.2, 0.3}, 0.6}, {2, 80.0, {}, 0.4}};
  answer.recognition.map_from_robot = {3.0, 4.0, 0.0};
  answer.labels = {"e", "b"};
  const Recognition message = toMessage(answer, kHeader, ros::Duration(0.25));
  EXPECT_EQ(message.verdict, Recognition::AMBIGUOUS);
  ASSERT_EQ(message.matches.size(), 2U);
  EXPECT_EQ(message.matches[0].id, 5);
  EXPECT_EQ(message.matches[0].label, "e");
  EXPECT_EQ(message.matches[0].score, 90.0);
  EXPECT_EQ(message.matches[0].transform.y, 0.2);
  EXPECT_EQ(message.matches[0].probability, 0.6);
  EXPECT_EQ(message.matches[1].label, "b");
  EXPECT_EQ(message.pose.pose.position.x, 3.0);
  EXPECT_EQ(message.match_duration, ros::Duration(0.25));
}

TEST(ToMessage, EachVerdictHasItsConstant) {
  core::PlaceMemory::Answer answer;
  const auto verdict = [&answer](core::Verdict value) {
    answer.recognition.verdict = value;
    return toMessage(answer, kHeader, ros::Duration()).verdict;
  };
  EXPECT_EQ(verdict(core::Verdict::kUnknown), Recognition::UNKNOWN);
  EXPECT_EQ(verdict(core::Verdict::kAmbiguous), Recognition::AMBIGUOUS);
  EXPECT_EQ(verdict(core::Verdict::kRecognized), Recognition::RECOGNIZED);
}

TEST(ToNanoseconds, IsTheReverseOfToRosTime) {
  for (const ros::Time time :
       {ros::Time(0, 0), ros::Time(1500000000, 7), ros::Time(4294967295, 0)}) {
    EXPECT_EQ(toRosTime(toNanoseconds(time)), time);
  }
}

TEST(ScanFrame, IsThatOfOdometryWhereThereIsOne) {
  config::Parameters parameters;
  EXPECT_EQ(scanFrame(parameters), "odom");
  parameters.odom_frame = "";
  EXPECT_EQ(scanFrame(parameters), "map");
}

}  // namespace
}  // namespace place_memory::node
