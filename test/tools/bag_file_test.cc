#include "tools/bag_file.h"

#include <gtest/gtest.h>
#include <sensor_msgs/Range.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/temporary_folder.h"

namespace place_memory::tools {
namespace {

// Why a bag cannot be opened.
std::string whyNot(const std::string& path) {
  rosbag::Bag bag;
  try {
    openBag(path, bag);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expectSays(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(OpenBag, ABagThatWasNeverClosedWantsToBeIndexed) {
  const TemporaryFolder folder;
  const std::string cut = folder.file("cut.bag");
  const std::string path = folder.file("test.bag");
  rosbag::Bag bag(cut, rosbag::bagmode::Write);
  bag.write("/sonar", ros::Time(1000.5), sensor_msgs::Range());
  std::filesystem::copy_file(cut, path);
  bag.close();
  expectSays(whyNot(path), "rosbag reindex " + path);
}

TEST(OpenBag, ABagThatWasNotCopiedWholeIsToldFromWhatIsNone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("test.bag");
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.write("/sonar", ros::Time(1000.5), sensor_msgs::Range());
  bag.close();
  EXPECT_EQ(whyNot(path), "");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 500);
  expectSays(whyNot(path), "was it copied whole? If so, run: rosbag reindex " + path);
  const std::string text = folder.file("notes.bag");
  std::ofstream(text) << "hello\n";
  expectSays(whyNot(text), "it is no bag of ROS 1");
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
