#include "tools/bag_set.h"

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <utility>

#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

using Times = std::vector<double>;

class BagSetTest : public testing::Test {
 protected:
  /// A bag of ranges with these stamps, each recorded when `recorded` says, or at its stamp.
  std::string write(const std::string& name, const Times& stamps, const Times& recorded = {}) {
    rosbag::Bag bag(folder_.file(name), rosbag::bagmode::Write);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      sensor_msgs::Range range;
      range.header.frame_id = "sonar_0";
      range.header.stamp = ros::Time(stamps[i]);
      bag.write("/sonar", ros::Time(recorded.empty() ? stamps[i] : recorded[i]), range);
    }
    bag.close();
    return folder_.file(name);
  }

  static Times read(const BagSet& bags, double start, double end) {
    Times times;
    bags.read({"sonar"}, ros::Time(start), ros::Time(end),
              [&](const TimedMessage& timed) { times.push_back(timed.time.toSec()); });
    return times;
  }

  std::string problem(const std::vector<std::string>& paths) const {
    try {
      const BagSet bags(paths, {"sonar"});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
};

TEST_F(BagSetTest, WhatWasRecordedLateIsReadByItsStamps) {
  // Two sensors in turn, of which one is held up for ten seconds, as by a network.
  std::vector<std::pair<double, int>> recorded;  // when, and which
  for (int i = 0; i < 40; ++i) {
    const bool is_late = i % 2 == 1 && i >= 10 && i < 20;
    recorded.emplace_back(is_late ? 30.5 : 10.0 + i, i);
  }
  std::stable_sort(recorded.begin(), recorded.end());
  rosbag::Bag bag(folder_.file("a.bag"), rosbag::bagmode::Write);
  Times stamps;
  for (const auto& [time, number] : recorded) {
    sensor_msgs::Range range;
    range.header.frame_id = number % 2 == 0 ? "sonar_0" : "sonar_1";
    range.header.stamp = ros::Time(10.0 + number);
    bag.write("/sonar", ros::Time(time), range);
    stamps.push_back(10.0 + static_cast<double>(stamps.size()));
  }
  bag.close();
  const BagSet bags({folder_.file("a.bag")}, {"sonar"});
  EXPECT_TRUE(bags.notes().empty());
  EXPECT_EQ(read(bags, 0, 100), stamps);
  EXPECT_EQ(read(bags, 20.5, 23.5), (Times{21, 22, 23}));
}

TEST_F(BagSetTest, AStampThatCannotBeRightCountsWhenItCame) {
  const BagSet bags({write("a.bag", {10, 11, 1, 13, 900, 15, 16}, {10, 11, 12, 13, 14, 15, 16})},
                    {"sonar"});
  EXPECT_EQ(read(bags, 0, 100), (Times{10, 11, 12, 13, 14, 15, 16}));
  EXPECT_EQ(bags.first(), ros::Time(10.0));
  EXPECT_EQ(bags.last(), ros::Time(16.0));
}

TEST_F(BagSetTest, SeveralBagsAreReadAsOneWhateverTheirOrder) {
  const std::string early = write("early.bag", {10, 11, 12});
  const std::string late = write("late.bag", {13, 14, 15});
  const BagSet bags({late, early}, {"sonar"});
  EXPECT_EQ(read(bags, 0, 100), (Times{10, 11, 12, 13, 14, 15}));
  EXPECT_TRUE(bags.notes().empty());
  EXPECT_EQ(bags.first(), ros::Time(10.0));
  EXPECT_EQ(bags.last(), ros::Time(15.0));
  EXPECT_EQ(bags.name(), "the bags " + early + " and " + late);
}

TEST_F(BagSetTest, EachBagHasAnOffsetOfItsOwn) {
  const BagSet bags({write("a.bag", {10, 11, 12}, {40, 41, 42}),
                     write("b.bag", {10.5, 11.5, 12.5}, {5.5, 6.5, 7.5})},
                    {"sonar"});
  EXPECT_EQ(read(bags, 0, 100), (Times{10, 10.5, 11, 11.5, 12, 12.5}));
  const std::vector<std::string> notes = bags.notes();
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_NE(notes[0].find("30.00 s ahead of the header stamps"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("5.00 s behind the header stamps"), std::string::npos) << notes[1];
}

TEST_F(BagSetTest, WhatSeveralBagsHoldIsReadOnceAndTheOverlapSaid) {
  const BagSet bags({write("a.bag", {10, 11, 11, 12}), write("b.bag", {11, 12, 13})}, {"sonar"});
  // One bag may hold a message twice.
  EXPECT_EQ(read(bags, 0, 100), (Times{10, 11, 11, 12, 13}));
  ASSERT_EQ(bags.notes().size(), 1U);
  EXPECT_NE(bags.notes()[0].find("overlap by 1.00 s"), std::string::npos) << bags.notes()[0];
}

TEST_F(BagSetTest, AGapIsSaid) {
  const BagSet bags({write("a.bag", {10, 11}), write("b.bag", {100, 101})}, {"sonar"});
  ASSERT_EQ(bags.notes().size(), 1U);
  EXPECT_NE(bags.notes()[0].find("a gap of 89.00 s"), std::string::npos) << bags.notes()[0];
  EXPECT_EQ(bags.missing(ros::Time(50.0), ros::Time(60.0)), "it lies in a gap between the bags");
  EXPECT_EQ(bags.missing(ros::Time(10.5), ros::Time(60.0)), "");
}

TEST_F(BagSetTest, EventsBesideTheBagAreToldApart) {
  const BagSet bags({write("a.bag", {1000.5, 1002})}, {"sonar"});
  EXPECT_EQ(bags.missing(ros::Time(1001.0), ros::Time(1003.0)), "");
  EXPECT_EQ(bags.missing(ros::Time(1.0), ros::Time(1000.5)), "");
  EXPECT_EQ(bags.missing(ros::Time(1.0), ros::Time(2.0)),
            "it lies before what the bag holds, which is from 1000.500 to 1002.000 s");
  EXPECT_EQ(bags.missing(ros::Time(1003.0), ros::Time(1004.0)),
            "it lies after what the bag holds, which is from 1000.500 to 1002.000 s");
}

TEST_F(BagSetTest, TwoSourcesOfTheClockAreNamed) {
  const std::string path = folder_.file("clocks.bag");
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (const char* node : {"/gazebo", "/play"}) {
    auto header = boost::make_shared<ros::M_string>();
    (*header)["callerid"] = node;
    for (int i = 0; i < 5; ++i) {
      rosgraph_msgs::Clock clock;
      clock.clock = ros::Time(10.0 + i);
      bag.write("/clock", ros::Time(10.0 + i), clock, header);
    }
  }
  bag.close();
  const std::vector<std::string> notes = BagSet({path}, {"sonar"}).notes();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("several sources (/gazebo, /play)"), std::string::npos) << notes[0];
}

TEST_F(BagSetTest, ABagWithoutMessagesIsRefused) {
  EXPECT_NE(problem({write("a.bag", {10}), write("b.bag", {})}).find("b.bag holds no message"),
            std::string::npos);
}

}  // namespace
}  // namespace place_memory::tools
