#include "tools/bag_file.h"

#include <gtest/gtest.h>
#include <sensor_msgs/Range.h>

#include <filesystem>
#include <stdexcept>

#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

TEST(OpenBag, ABagThatWasNeverClosedWantsToBeIndexed) {
  const TemporaryFolder folder;
  const std::string cut = folder.file("cut.bag");
  const std::string path = folder.file("test.bag");
  rosbag::Bag bag(cut, rosbag::bagmode::Write);
  bag.write("/sonar", ros::Time(1000.5), sensor_msgs::Range());
  std::filesystem::copy_file(cut, path);
  bag.close();
  rosbag::Bag opened;
  try {
    openBag(path, opened);
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("rosbag reindex " + path), std::string::npos) << text;
  }
}

TEST(RefuseOtherDefinition, KnowsTfByBothItsNames) {
  rosbag::ConnectionInfo connection;
  connection.topic = "/tf";
  connection.md5sum = "94810edda583a504dfda3829e70d7eec";
  for (const char* type : {"tf2_msgs/TFMessage", "tf/tfMessage"}) {
    connection.datatype = type;
    EXPECT_NO_THROW(refuseOtherDefinition("a.bag", connection)) << type;
  }
  connection.md5sum = "0123456789abcdef0123456789abcdef";
  EXPECT_THROW(refuseOtherDefinition("a.bag", connection), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::tools
