#include "tools/bag_file.h"

#include <gtest/gtest.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/String.h>

#include "config/load_parameters.h"
#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

class BagFile : public testing::Test {
 protected:
  std::string path() const { return folder_.file("test.bag"); }

  std::string problem() const {
    try {
      checkBag(path(), config::loadParameters({}));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
};

TEST_F(BagFile, TellsWhatTheBagHolds) {
  rosbag::Bag bag(path(), rosbag::bagmode::Write);
  bag.write("/sonar", ros::Time(1000.5), sensor_msgs::Range());
  bag.write("/chatter", ros::Time(1002.0), std_msgs::String());
  bag.close();
  const BagTimes times = checkBag(path(), config::loadParameters({}));
  EXPECT_EQ(times.first, ros::Time(1000.5));
  EXPECT_EQ(times.last, ros::Time(1002.0));
}

TEST_F(BagFile, EventsBesideTheBagAreToldApart) {
  const BagTimes times{ros::Time(1000.5), ros::Time(1002.0)};
  EXPECT_EQ(times.missing(ros::Time(1001.0), ros::Time(1003.0)), "");
  EXPECT_EQ(times.missing(ros::Time(1.0), ros::Time(1000.5)), "");
  EXPECT_EQ(times.missing(ros::Time(1.0), ros::Time(2.0)),
            "it lies before what the bag holds, which is from 1000.500 to 1002.000 s");
  EXPECT_EQ(times.missing(ros::Time(1003.0), ros::Time(1004.0)),
            "it lies after what the bag holds, which is from 1000.500 to 1002.000 s");
}

TEST_F(BagFile, ABagWithoutMessagesIsRefused) {
  rosbag::Bag(path(), rosbag::bagmode::Write).close();
  EXPECT_NE(problem().find("holds no message"), std::string::npos) << problem();
}

TEST_F(BagFile, ABagThatWasNeverClosedWantsToBeIndexed) {
  const std::string cut = folder_.file("cut.bag");
  rosbag::Bag bag(cut, rosbag::bagmode::Write);
  bag.write("/sonar", ros::Time(1000.5), sensor_msgs::Range());
  std::filesystem::copy_file(cut, path());
  bag.close();
  const std::string text = problem();
  EXPECT_NE(text.find("rosbag reindex " + path()), std::string::npos) << text;
}

}  // namespace
}  // namespace place_memory::tools
