#include "node/drive/drive_input.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include <string>

#include "node/input/transform_filter.h"

namespace place_memory::node {
namespace {

class DriveInputTest : public testing::Test {
 protected:
  DriveInputTest() {
    ros::Time::init();
    ros::Time::setNow(ros::Time(1000));
  }

  static geometry_msgs::TransformStamped from(const std::string& parent, const std::string& child) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(1000);
    transform.child_frame_id = child;
    transform.transform.rotation.w = 1.0;
    return transform;
  }

  DriveInput::Batch fetch() { return input_.fetch(std::chrono::nanoseconds(0)); }

  const config::Parameters parameters_;
  DriveInput input_{parameters_};
};

TEST_F(DriveInputTest, StaticTransformsAreThereWhenTheModeChanges) {
  input_.take(from("base_link", "sonar"), true);
  input_.turn(true);
  ASSERT_EQ(fetch().statics.size(), 1U);
  input_.take(from("odom", "base_link"), false);
  EXPECT_EQ(fetch().moments.size(), 1U);
}

TEST_F(DriveInputTest, EverNewFramesTakeNoMemory) {
  for (std::size_t i = 0; i < kMostFrames + 500; ++i) {
    input_.take(from("base_link", "frame_" + std::to_string(i)), true);
  }
  // What is known may still move.
  geometry_msgs::TransformStamped moved = from("base_link", "frame_7");
  moved.transform.translation.x = 3.0;
  input_.take(moved, true);
  input_.turn(true);
  const DriveInput::Batch batch = fetch();
  EXPECT_EQ(batch.statics.size(), kMostFrames);
  for (const auto& transform : batch.statics) {
    const bool is_moved = transform.child_frame_id == "frame_7";
    EXPECT_EQ(transform.transform.translation.x, is_moved ? 3.0 : 0.0);
  }
}

TEST_F(DriveInputTest, WhatIsNoTransformIsLeftOutAndSaid) {
  input_.turn(true);
  input_.take(from("base_link", std::string(100000, 'x')), true);
  EXPECT_TRUE(fetch().statics.empty());
  geometry_msgs::TransformStamped wrong = from("odom", "base_link");
  wrong.transform.translation.x = 1e300;
  input_.take(wrong, false);
  const DriveInput::Batch batch = fetch();
  EXPECT_TRUE(batch.moments.empty());
  EXPECT_NE(batch.losses.problem.find("further than anything lies"), std::string::npos)
      << batch.losses.problem;
}

}  // namespace
}  // namespace place_memory::node
