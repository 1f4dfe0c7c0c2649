// Writes what scripts/fuzz begins with that no file of the package is: messages and small stores.
// usage: fuzz_seeds FOLDER
#include <place_memory/ExploreGoal.h>
#include <place_memory/GoToPlaceGoal.h>
#include <ros/serialization.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "core/random_room.h"
#include "core/store/later_store_fixture.h"
#include "core/store/old_store_fixture.h"
#include "core/store/packed_edits.h"
#include "core/store/scans_fixture.h"
#include "core/store/unfinished_change.h"
#include "node/input/input_message.h"

namespace place_memory {
namespace {

namespace fs = std::filesystem;

/// As runMessages() reads it.
template <class Content>
std::string inputOf(std::uint8_t type, const Content& content) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(content));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, content);
  const std::size_t size = bytes.size() + 1;
  std::string input{static_cast<char>(size & 0xffU), static_cast<char>(size >> 8U),
                    static_cast<char>(type)};
  return input.append(bytes.begin(), bytes.end());
}

template <class Content>
Content stamped(const std::string& frame) {
  Content message;
  message.header.stamp = ros::Time(999.5);
  message.header.frame_id = frame;
  return message;
}

void writeMessages(const std::string& folder) {
  auto range = stamped<sensor_msgs::Range>("sonar_1");
  range.field_of_view = 0.4F;
  range.max_range = 4.0F;
  range.range = 1.5F;
  auto cloud = stamped<sensor_msgs::PointCloud>("ring");
  cloud.points.resize(2);
  cloud.points[0].x = 1.0F;
  cloud.points[1].y = 2.0F;
  auto cloud2 = stamped<sensor_msgs::PointCloud2>("ring");
  cloud2.height = 1;
  cloud2.width = 2;
  cloud2.point_step = 8;
  cloud2.row_step = 16;
  cloud2.fields.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    cloud2.fields[i].name = i == 0 ? "x" : "y";
    cloud2.fields[i].offset = static_cast<std::uint32_t>(4 * i);
    cloud2.fields[i].datatype = sensor_msgs::PointField::FLOAT32;
    cloud2.fields[i].count = 1;
  }
  cloud2.data.resize(16, 63);
  auto scan = stamped<sensor_msgs::LaserScan>("laser");
  scan.angle_min = -1.0F;
  scan.angle_max = 1.0F;
  scan.angle_increment = 0.5F;
  scan.range_max = 8.0F;
  scan.ranges = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F};
  auto imu = stamped<sensor_msgs::Imu>("base_link");
  imu.orientation.w = 1.0;
  auto field = stamped<sensor_msgs::MagneticField>("base_link");
  field.magnetic_field.x = 2e-5;
  std_msgs::Float64 bearing;
  bearing.data = 90.0;
  auto odometry = stamped<nav_msgs::Odometry>("odom");
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.orientation.w = 1.0;
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(stamped<geometry_msgs::TransformStamped>("base_link"));
  transforms.transforms[0].child_frame_id = "sonar_1";
  transforms.transforms[0].transform.rotation.w = 1.0;
  const std::vector<std::string> inputs{
      inputOf(0, range),    inputOf(2, cloud),     inputOf(4, cloud2),
      inputOf(6, scan),     inputOf(8, imu),       inputOf(10, field),
      inputOf(12, bearing), inputOf(14, odometry), inputOf(16, transforms)};
  std::string all;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    writeFile(folder + "/message-" + std::to_string(i), inputs[i]);
    all += inputs[i];
  }
  writeFile(folder + "/messages", all);
}

void writeStores(const std::string& folder) {
  const std::string path = folder + "/store";
  core::PlaceStore(path, core::kDefaultCellSize);
  fs::copy_file(path, folder + "/empty");
  {
    core::PlaceStore store(path, core::kDefaultCellSize);
    core::add(store, core::makePlace("a"), core::makeGrid(1), core::kNoPlace);
    core::add(store, core::makePlace("b"), core::makeGrid(2), 1);
    core::MapChange change;
    change.version = 2;
    store.commit(change, core::makeScans());
  }
  fs::copy_file(path, folder + "/format-3");
  core::makeFormat3(folder + "/format-3");
  fs::copy_file(path, folder + "/format-4");
  core::makeFormat4(folder + "/format-4");
  fs::copy_file(path, folder + "/hot");
  core::leaveUnfinished(folder + "/hot",
                        "UPDATE store SET map_version = 3; UPDATE place SET label = 'x' || label");
  const std::string hot = readFile(folder + "/hot");
  writeFile(folder + "/hot", hot + readFile(folder + "/hot-journal"));
  fs::remove(folder + "/hot-journal");
}

void write(const std::string& path, const core::BytePacker& bytes) {
  writeFile(path, {bytes.bytes().begin(), bytes.bytes().end()});
}

// Round a room, as runMapper() reads it.
void writeDrive(const std::string& folder) {
  const core::RandomRoom room(7);
  core::BytePacker bytes;
  core::Pose2d pose{0.6, 0.0, core::kPi / 2.0};
  for (int step = 0; step < 900; ++step) {
    bytes.add(std::uint8_t{0}).add(std::int8_t{20}).add(std::int8_t{17});
    pose = pose * core::Pose2d{0.08, 0.0, 0.136};
    const core::Scan scan = room.scanFrom(pose);
    for (std::size_t i = 0; i < 8; ++i) {
      bytes.add(static_cast<std::uint8_t>(std::min(255.0, 50.0 * scan.readings[2 * i].range)));
    }
    if (step % 300 == 299) bytes.add(std::uint8_t{130});  // takes the map up
  }
  write(folder + "/drive", bytes);
}

// As runEdits() reads them.
void writeEdits(const std::string& folder) {
  core::PlaceAdded first{core::makePlace("a"), nullptr, nullptr};
  first.place.id = 1;
  first.grid = std::make_shared<core::EvidenceGrid>(core::makeGrid(1));
  core::PlaceAdded second = first;
  second.place = core::makePlace("b");
  second.place.id = 2;
  core::BytePacker bytes;
  core::packEdits({first, second, core::LinkAdded{core::makeLink(1, 2)},
                   core::LinkLearned{2, 1, core::makeLink(1, 2).forward},
                   core::PlaceMoved{1, {1.0, 2.0, 0.5}, 1}, core::PlaceRenamed{2, "c"},
                   core::GridAdapted{2, first.grid}, core::LinkRemoved{1, 2}, core::PlaceRemoved{1},
                   core::MapCleared{}},
                  bytes);
  write(folder + "/edits", bytes);
}

// As runMemory() reads them.
void writeQuestions(const std::string& folder) {
  core::BytePacker bytes;
  const std::int8_t a = 1;
  const std::int8_t b = 2;
  bytes.add(std::uint8_t{0}).add(std::string("kitchen"));
  bytes.add(std::uint8_t{1}).add(std::string("kitchen")).add(std::string("hall"));
  bytes.add(std::uint8_t{3}).add(a).add(b).add(std::int64_t{1000}).add(std::int64_t{2000});
  bytes.add(std::uint8_t{0}).add(std::string("me"));
  bytes.add(std::uint8_t{4}).add(a).add(std::uint8_t{3}).add(7.5).add(b).add(std::uint8_t{0});
  bytes.add(std::uint8_t{7}).add(std::uint8_t{0}).add(std::uint8_t{0}).add(a).add(std::uint8_t{1});
  bytes.add(b).add(std::uint8_t{1}).add(std::string("c")).add(std::uint8_t{1}).add(a).add(b);
  bytes.add(std::uint8_t{2}).add(std::string("hall"));
  bytes.add(std::uint8_t{5}).add(std::uint8_t{1});
  write(folder + "/questions", bytes);
}

template <class Goal>
core::BytePacker packed(std::uint8_t action, const Goal& goal) {
  std::string message(ros::serialization::serializationLength(goal), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(message.data()),
                                     static_cast<std::uint32_t>(message.size()));
  ros::serialization::serialize(stream, goal);
  core::BytePacker bytes;
  bytes.add(action).add(message);
  return bytes;
}

// As runGoals() reads them.
void writeGoals(const std::string& folder) {
  GoToPlaceGoal goal;
  goal.label = "c";
  core::BytePacker to_label = packed(0, goal);
  for (const int deed : {0, 3, 1, 0, 2}) {
    to_label.add(std::uint16_t{900}).add(static_cast<std::uint8_t>(deed));
    if (deed == 2) to_label.add(std::int8_t{3});
  }
  write(folder + "/label", to_label);
  goal.label.clear();
  goal.pose.header.frame_id = "map";
  goal.pose.pose.position.x = 5.0;
  core::BytePacker to_pose = packed(0, goal);
  to_pose.add(std::uint16_t{900}).add(std::uint8_t{0}).add(std::uint16_t{5}).add(std::uint8_t{1});
  write(folder + "/pose", to_pose);
  ExploreGoal about;
  about.most_distance = 20.0;
  core::BytePacker explore = packed(1, about);
  for (int i = 0; i < 12; ++i) {
    for (int sonar = -4; sonar < 4; ++sonar) {
      explore.add(std::uint8_t{1}).add(static_cast<std::int8_t>(30 * sonar)).add(std::uint8_t{110});
    }
    explore.add(std::uint8_t{0}).add(std::int8_t{25}).add(std::int8_t{0}).add(std::int8_t{5});
    explore.add(static_cast<std::uint8_t>(i % 4 == 3 ? 3 : 2));
  }
  write(folder + "/explore", explore);
}

}  // namespace
}  // namespace place_memory

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  for (const char* const name : {"messages", "store", "mapper", "edits", "memory", "goals"}) {
    std::filesystem::create_directories(folder + "/" + name);
  }
  place_memory::writeMessages(folder + "/messages");
  place_memory::writeStores(folder + "/store");
  place_memory::writeDrive(folder + "/mapper");
  place_memory::writeEdits(folder + "/edits");
  place_memory::writeQuestions(folder + "/memory");
  place_memory::writeGoals(folder + "/goals");
}
