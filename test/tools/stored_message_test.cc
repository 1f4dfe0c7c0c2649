#include "tools/stored_message.h"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

namespace place_memory::tools {
namespace {

template <class Message>
StoredMessage stored(const Message& message) {
  StoredMessage stored;
  stored.md5sum = ros::message_traits::md5sum(message);
  stored.bytes.resize(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(stored.bytes.data(),
                                     static_cast<std::uint32_t>(stored.bytes.size()));
  ros::serialization::serialize(stream, message);
  return stored;
}

template <class Message>
StampLayout layoutOf(const Message& message) {
  return stampLayout(ros::message_traits::datatype(message),
                     ros::message_traits::definition(message));
}

TEST(StoredMessage, IsWhatItWas) {
  sensor_msgs::Range range;
  range.range = 2.5F;
  const auto read = stored(range).as<sensor_msgs::Range>();
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->range, 2.5F);
  EXPECT_EQ(stored(range).as<std_msgs::String>(), nullptr);
  StoredMessage cut = stored(range);
  cut.bytes.pop_back();
  EXPECT_THROW(cut.as<sensor_msgs::Range>(), ros::Exception);
}

TEST(OriginOf, IsThatOfTheHeader) {
  sensor_msgs::Range range;
  range.header.stamp = ros::Time(12, 345);
  range.header.frame_id = "sonar_3";
  ASSERT_EQ(layoutOf(range), StampLayout::kHeader);
  const auto origin = originOf(stored(range), StampLayout::kHeader);
  ASSERT_TRUE(origin.has_value());
  EXPECT_EQ(origin->stamp, ros::Time(12, 345));
  EXPECT_EQ(origin->frame, "sonar_3");
}

TEST(OriginOf, IsThatOfTheFirstTransform) {
  tf2_msgs::TFMessage moved;
  ASSERT_EQ(layoutOf(moved), StampLayout::kTransforms);
  EXPECT_FALSE(originOf(stored(moved), StampLayout::kTransforms).has_value());
  moved.transforms.resize(2);
  moved.transforms[0].header.stamp = ros::Time(7.0);
  moved.transforms[0].header.frame_id = "odom";
  moved.transforms[0].child_frame_id = "base_link";
  const auto origin = originOf(stored(moved), StampLayout::kTransforms);
  ASSERT_TRUE(origin.has_value());
  EXPECT_EQ(origin->stamp, ros::Time(7.0));
  EXPECT_EQ(origin->frame, "base_link");
}

TEST(OriginOf, WhatIsCutHasNone) {
  sensor_msgs::Range range;
  range.header.frame_id = "sonar_3";
  for (const std::size_t size : {0U, 3U, 11U, 15U, 18U}) {
    StoredMessage message = stored(range);
    message.bytes.resize(size);
    EXPECT_FALSE(originOf(message, StampLayout::kHeader).has_value()) << size;
    EXPECT_FALSE(originOf(message, StampLayout::kTransforms).has_value()) << size;
  }
}

TEST(StampLayout, IsReadFromTheDefinition) {
  EXPECT_EQ(layoutOf(std_msgs::String()), StampLayout::kNone);
  EXPECT_EQ(layoutOf(geometry_msgs::TransformStamped()), StampLayout::kHeader);
  EXPECT_EQ(stampLayout("my/Type", "# text\n\nuint8 A=1 # one\n std_msgs/Header header\r\nint8 b"),
            StampLayout::kHeader);
  EXPECT_EQ(stampLayout("my/Type", "int8 b\nHeader header\n"), StampLayout::kNone);
  EXPECT_EQ(stampLayout("my/Type", ""), StampLayout::kNone);
}

}  // namespace
}  // namespace place_memory::tools
