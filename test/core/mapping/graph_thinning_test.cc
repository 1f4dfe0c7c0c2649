#include "core/mapping/graph_thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace place_memory::core {
namespace {

/// Laps over three places at 0, 4 and 8 m, and back: a scan each metre. Scans at places are tied.
class Laps {
 public:
  void drive(int laps) {
    for (int i = 0; i < 16 * laps; ++i) {
      const int step = i % 16;
      append(step <= 8 ? step : 16 - step);
    }
  }
  /// Odometry starts anew.
  void restart() { cut_ = true; }
  ScanGraph& graph() { return graph_; }

  std::size_t untied() const {
    return static_cast<std::size_t>(
        std::count_if(graph_.nodes().begin(), graph_.nodes().end(), [this](const ScanNode& node) {
          return node.place == kNoPlace && !graph_.tied(&node - graph_.nodes().data());
        }));
  }

 private:
  void append(int x) {
    ScanNode node;
    node.session = 1;
    node.pose = {static_cast<double>(x), 0.0, 0.0};
    if (!graph_.nodes().empty() && !cut_) {
      node.before = graph_.nodes().size() - 1;
      node.motion = {node.pose.x - graph_.nodes().back().pose.x, 0.0, 0.0};
      node.motion_way = 1.0;
    }
    cut_ = false;
    const bool is_new = x % 4 == 0 && places_.count(x) == 0;
    if (is_new) node.place = x / 4 + 1;
    const NodeIndex at = graph_.append(node);
    if (is_new) places_[x] = at;
    if (x % 4 != 0 || is_new) return;
    graph_.tie({places_[x], at, {}, Eigen::Matrix3d::Identity(), 0});
  }

  ScanGraph graph_;
  std::map<int, NodeIndex> places_;
  bool cut_ = false;
};

/// Every node can be reached from the first one, by odometry and ties.
bool hangsTogether(const ScanGraph& graph) {
  std::vector<char> reached(graph.nodes().size(), 0);
  std::vector<NodeIndex> open{0};
  std::vector<ScanGraph::Step> steps;
  reached[0] = 1;
  while (!open.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    graph.steps(at, steps);
    for (const ScanGraph::Step& step : steps) {
      if (!reached[step.to]) open.push_back(step.to);
      reached[step.to] = 1;
    }
  }
  return std::count(reached.begin(), reached.end(), 0) == 0;
}

const ThinningOptions kFew{4, 1, 20, 5.0};

TEST(GraphThinning, AFreshMapStaysAsItIs) {
  Laps laps;
  laps.drive(1);
  EXPECT_FALSE(thin(laps.graph(), kFew));
}

TEST(GraphThinning, LapsLeaveAMapAsLargeAsTheWayIsLong) {
  Laps few, many;
  few.drive(10);
  many.drive(100);
  ASSERT_TRUE(thin(few.graph(), kFew));
  ASSERT_TRUE(thin(many.graph(), kFew));
  EXPECT_EQ(many.graph().nodes().size(), few.graph().nodes().size());
  // Three places, four visits of each, three scans on each of two ways between them; the newest
  // twenty stay in any case.
  EXPECT_LE(many.graph().nodes().size(), 3 + 3 * 4 + 2 * 3 + kFew.newest);
  EXPECT_TRUE(hangsTogether(many.graph()));
}

TEST(GraphThinning, WhatIsLeftIsFollowedByOdometry) {
  Laps laps;
  laps.drive(10);
  thin(laps.graph(), kFew);
  for (const ScanNode& node : laps.graph().nodes()) {
    if (!node.before) continue;
    const Pose2d there = laps.graph().node(*node.before).pose * node.motion;
    EXPECT_NEAR(there.x, node.pose.x, 1e-9);
    EXPECT_LE(node.motion_way, kFew.longest);
  }
}

TEST(GraphThinning, WaysThatBeginWhereOdometryDoesDoNotPileUp) {
  Laps laps;
  for (int i = 0; i < 50; ++i) {
    laps.drive(1);
    laps.restart();
  }
  thin(laps.graph(), kFew);
  EXPECT_LE(laps.untied(), 2 * 3 + 2 * 3 + kFew.newest);
  EXPECT_TRUE(hangsTogether(laps.graph()));
}

TEST(GraphThinning, NewGroundStaysThoughNothingTiesIt) {
  Laps laps;
  laps.drive(10);
  const std::size_t before = laps.graph().nodes().size();
  for (int i = 0; i < 60; ++i) {
    ScanNode node;
    node.session = 1;
    node.pose = {0.0, static_cast<double>(i + 1), 0.0};
    node.before = laps.graph().nodes().size() - 1;
    node.motion_way = 1.0;
    laps.graph().append(node);
  }
  const auto now = thin(laps.graph(), kFew);
  ASSERT_TRUE(now);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_TRUE((*now)[before + i]);
}

}  // namespace
}  // namespace place_memory::core
