#include "core/mapping/final_way.h"

#include <gtest/gtest.h>

#include <vector>

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;

ScanNode makeNode(int stamp, const Pose2d& odom_from_base, const Pose2d& pose) {
  ScanNode node;
  node.stamp = nanoseconds(stamp);
  node.session = 1;
  node.odom_from_base = odom_from_base;
  node.pose = pose;
  return node;
}

TEST(FinalWay, SpreadsWhatTwoScansSayOverTheWayBetweenThem) {
  const std::vector<ScanNode> nodes = {makeNode(100, {0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}),
                                       makeNode(200, {1.0, 0.0, 0.0}, {6.0, 0.4, 0.2})};
  const FinalWay way(nodes);
  EXPECT_NEAR(way.at(nanoseconds(100), {0.0, 0.0, 0.0}).x, 5.0, 1e-12);
  const Pose2d half = way.at(nanoseconds(150), {1.0, 0.0, 0.0});
  EXPECT_NEAR(half.x, 6.0, 1e-12);
  EXPECT_NEAR(half.y, 0.2, 1e-12);
  EXPECT_NEAR(half.yaw, 0.1, 1e-12);
  const Pose2d last = way.at(nanoseconds(200), {1.0, 0.0, 0.0});
  EXPECT_NEAR(last.y, 0.4, 1e-12);
}

TEST(FinalWay, GoesOnByOdometryBeforeTheFirstScanAndAfterTheLast) {
  const FinalWay way({makeNode(100, {1.0, 0.0, 0.0}, {5.0, 0.0, kPi / 2.0})});
  EXPECT_NEAR(way.at(nanoseconds(50), {0.5, 0.0, 0.0}).y, -0.5, 1e-12);
  EXPECT_NEAR(way.at(nanoseconds(500), {3.0, 0.0, 0.0}).y, 2.0, 1e-12);
}

TEST(FinalWay, LeavesOutWhatIsNotJoinedToTheMap) {
  std::vector<ScanNode> nodes = {makeNode(50, {}, {7.0, 0.0, 0.0}),
                                 makeNode(60, {}, {9.0, 0.0, 0.0})};
  nodes[1].session = 2;
  EXPECT_NEAR(FinalWay(nodes).at(nanoseconds(100), {}).x, 7.0, 1e-12);
  EXPECT_TRUE(FinalWay({nodes[1]}).empty());
}

}  // namespace
}  // namespace place_memory::core
