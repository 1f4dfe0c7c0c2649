#include "core/mapping/loop_closer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "config/load_parameters.h"
#include "core/mapping/dead_reckoning.h"
#include "core/mapping/moving_scan.h"
#include "sim/scene/world_loader.h"
#include "trials/simulated_drive.h"

namespace place_memory::core {
namespace {

/// A way through the office whose first part is mapped as it was; the rest lies where drift put it.
class LoopCloserTest : public testing::Test {
 protected:
  static constexpr double kMapped = 60.0;  // [m]

  LoopCloserTest()
      : parameters_(config::loadParameters({})),
        shelf_(parameters_.match.recognizer, SonarModel(parameters_.sonar), kDefaultCellSize),
        tying_(graph_, shelf_, parameters_.sonar, kDefaultCellSize),
        closer_(graph_, shelf_, tying_) {
    trials::DriveRecipe recipe;
    recipe.way = 110.0;
    recipe.changes = false;
    const trials::Drive drive = trials::simulateDrive(
        sim::loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/office.yaml"), {},
        recipe, 77);
    MovingScanBuilder builder({});
    DeadReckoning reckoning;
    std::optional<BaseMoment> last;
    for (const trials::DriveMoment& moment : drive) {
      reckoning.add(*moment.truth, {});
      const std::chrono::nanoseconds stamp(std::llround(moment.t * 1e9));
      for (const SonarReading& reading : moment.readings) {
        builder.add({stamp, *moment.truth, reckoning.pose(), reckoning.way(), reckoning.turn()},
                    reading);
        while (const auto scan = builder.take()) append(*scan, last);
      }
    }
    shelf_.ripen(1e9, graph_);
  }

  void append(const MovingScan& scan, std::optional<BaseMoment>& last) {
    ScanNode node;
    node.stamp = scan.middle.stamp;
    node.odom_from_base = scan.middle.odom_from_base;
    node.first_way = scan.first_way;
    node.last_way = scan.last_way;
    node.session = 1;
    node.readings = scan.readings;
    if (last) {
      node.before = graph_.nodes().size() - 1;
      node.motion = last->odom_from_base.inverse() * scan.middle.odom_from_base;
      node.motion_way = scan.middle.way - last->way;
      node.motion_turn = scan.middle.turn - last->turn;
    }
    last = scan.middle;
    truth_.push_back(scan.middle.odom_from_base);
    const bool mapped = scan.middle.way < kMapped;
    node.pose = mapped ? truth_.back() : drift_ * truth_.back();
    const NodeIndex at = graph_.append(node);
    if (mapped && shelf_.near(node.pose, 1, 1.3, false).empty()) shelf_.add(at, graph_);
    if (!mapped) drifted_.push_back(at);
  }

  /// Witnesses, by where a wrong or right transform puts the drifted scans.
  ClosureCandidate candidate(const Pose2d& map_from_estimate) const {
    ClosureCandidate found;
    found.target_from_estimate = map_from_estimate;
    for (const NodeIndex at : drifted_) {
      const Pose2d there = map_from_estimate * graph_.node(at).pose;
      const auto near = shelf_.near(there, 1, 1.0, true);
      if (near.empty()) continue;
      found.witnesses.push_back({at, near.front().id, graph_.node(at).last_way, there});
      if (found.witnesses.size() == 8) break;
    }
    return found;
  }

  double worst() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const Pose2d& pose = graph_.node(i).pose;
      worst = std::max(worst, std::hypot(pose.x - truth_[i].x, pose.y - truth_[i].y));
    }
    return worst;
  }

  config::Parameters parameters_;
  ScanGraph graph_;
  PlaceShelf shelf_;
  ScanTying tying_;
  LoopCloser closer_;
  Pose2d drift_{1.2, -0.9, 0.12};
  std::vector<Pose2d> truth_;
  std::vector<NodeIndex> drifted_;
};

TEST_F(LoopCloserTest, TheRightTransformClosesTheLoop) {
  const double before = worst();
  ASSERT_GT(before, 1.0);
  ASSERT_TRUE(closer_.close(candidate(drift_.inverse()), 1, 1, true, 60.0));
  EXPECT_GT(closer_.onTrial(), 0);
  EXPECT_GT(graph_.ties().size(), 4U);
  EXPECT_LT(worst(), 0.6 * before);
  // Found where it should be, the closure is proven.
  for (double way = 60.5; way < 67.0; way += 0.5) EXPECT_FALSE(closer_.observe(true, true, way));
  EXPECT_EQ(closer_.onTrial(), 0);
}

TEST_F(LoopCloserTest, FalseTransformsAreRefusedOrTakenBack) {
  const ScanGraph::Lie before = graph_.lie();
  int tried = 0;
  for (const Pose2d& wrong : {Pose2d{3.0, 0.0, 0.0}, Pose2d{0.0, 3.0, 0.0}, Pose2d{-4.0, 1.0, 0.0},
                              Pose2d{2.0, -4.0, 0.3}}) {
    const ClosureCandidate found = candidate(wrong * drift_.inverse());
    if (found.witnesses.size() < 5) continue;
    ++tried;
    if (closer_.close(found, 1, 1, true, 60.0)) {
      bool back = false;
      for (double way = 60.5; way < 64.0 && !back; way += 0.5) {
        back = closer_.observe(false, true, way);
      }
      EXPECT_TRUE(back);
      graph_.setLie(before);
    }
    EXPECT_TRUE(graph_.ties().empty());
    EXPECT_EQ(graph_.node(graph_.nodes().size() - 1).pose.x, before.poses.back().x);
  }
  EXPECT_GE(tried, 2);
}

TEST_F(LoopCloserTest, AClosureThatDoesNotAgreeAnyMoreIsCut) {
  ASSERT_TRUE(closer_.close(candidate(drift_.inverse()), 1, 1, true, 60.0));
  EXPECT_FALSE(closer_.cutContradicted());
  ScanGraph::Lie lie = graph_.lie();
  for (const NodeIndex at : drifted_) lie.poses[at] = Pose2d{2.0, 0.0, 0.0} * lie.poses[at];
  graph_.setLie(lie);
  EXPECT_TRUE(closer_.cutContradicted());
  EXPECT_TRUE(graph_.ties().empty());
}

}  // namespace
}  // namespace place_memory::core
