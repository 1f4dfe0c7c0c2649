#include "core/mapping/way_search.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

/// A way of half metres, `nodes` long.
ScanGraph straight(std::size_t nodes) {
  ScanGraph graph;
  for (std::size_t i = 0; i < nodes; ++i) {
    ScanNode node;
    node.session = 1;
    node.pose = {0.5 * static_cast<double>(i), 0.0, 0.0};
    if (i > 0) {
      node.before = i - 1;
      node.motion = {0.5, 0.0, 0.0};
      node.motion_way = 0.5;
    }
    graph.append(node);
  }
  return graph;
}

TEST(WaySearch, FollowsOdometryBothWaysUpToItsRadius) {
  const ScanGraph graph = straight(20);
  WaySearch search(graph, 10, 3.0);
  EXPECT_EQ(search.to(10), 0.0);
  EXPECT_DOUBLE_EQ(search.to(14).value(), 2.0);
  EXPECT_DOUBLE_EQ(search.to(4).value(), 3.0);
  EXPECT_FALSE(search.to(3));
  EXPECT_DOUBLE_EQ(search.to(12).value(), 1.0);
}

TEST(WaySearch, ATieThatAgreesIsAShortCutAndAnotherIsNone) {
  ScanGraph graph = straight(20);
  graph.tie({2, 18, {8.0, 0.0, 0.0}, 100.0 * Eigen::Matrix3d::Identity(), 0});
  EXPECT_LT(WaySearch(graph, 18, 50.0).to(2).value(), 0.2);
  graph.node(18).pose.x += 2.0;
  EXPECT_DOUBLE_EQ(WaySearch(graph, 18, 50.0).to(2).value(), 8.0);
}

}  // namespace
}  // namespace place_memory::core
