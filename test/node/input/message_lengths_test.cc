#include "node/input/message_lengths.h"

#include <gtest/gtest.h>
#include <sensor_msgs/Range.h>

#include <cstring>

namespace place_memory::node {
namespace {

template <class Content>
std::vector<std::uint8_t> bytesOf(const Content& content) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(content));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, content);
  return bytes;
}

template <class Content>
void expectReadAndRefusedWhereCut(const Content& content) {
  const std::vector<std::uint8_t> whole = bytesOf(content);
  Content read;
  readContent(whole, read);
  EXPECT_EQ(bytesOf(read), whole);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> cut(whole.begin(),
                                        whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(readContent(cut, read), ros::serialization::StreamOverrunException) << size;
  }
  // Every number in turn says that there are four thousand millions of something.
  for (std::size_t at = 0; at + 4 <= whole.size(); ++at) {
    std::vector<std::uint8_t> lying = whole;
    std::memset(lying.data() + at, 0xff, 4);
    try {
      readContent(lying, read);
      EXPECT_LE(bytesOf(read).size(), whole.size()) << at;
    } catch (const ros::serialization::StreamOverrunException&) {
    }
  }
}

TEST(MessageLengths, OfAFan) {
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = "laser";
  scan.ranges = {1.0F, 2.0F, 3.0F};
  scan.intensities = {0.5F};
  expectReadAndRefusedWhereCut(scan);
}

TEST(MessageLengths, OfClouds) {
  sensor_msgs::PointCloud cloud;
  cloud.header.frame_id = "ring";
  cloud.points.resize(2);
  cloud.channels.resize(1);
  cloud.channels[0].name = "intensity";
  cloud.channels[0].values = {1.0F, 2.0F};
  expectReadAndRefusedWhereCut(cloud);
  sensor_msgs::PointCloud2 cloud2;
  cloud2.header.frame_id = "ring";
  cloud2.height = 1;
  cloud2.width = 2;
  cloud2.fields.resize(2);
  cloud2.fields[1].name = "y";
  cloud2.data.resize(16);
  expectReadAndRefusedWhereCut(cloud2);
}

TEST(MessageLengths, OfTransforms) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(2);
  message.transforms[0].header.frame_id = "odom";
  message.transforms[0].child_frame_id = "base_link";
  expectReadAndRefusedWhereCut(message);
}

TEST(MessageLengths, OfWhatHasNoLists) {
  sensor_msgs::Range range;
  range.header.frame_id = "sonar_1";
  expectReadAndRefusedWhereCut(range);
}

}  // namespace
}  // namespace place_memory::node
