#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/store/later_store_fixture.h"

namespace place_memory::core {
namespace {

std::shared_ptr<const std::vector<SonarReading>> makeReadings(double range) {
  SonarReading echo;
  echo.sensor_pose = {0.25, -0.125, 1.5};
  echo.spec = {0.5, 0.25, 4.0};
  echo.range = range;
  SonarReading none = echo;
  none.range = std::numeric_limits<double>::infinity();
  return std::make_shared<const std::vector<SonarReading>>(std::vector<SonarReading>{echo, none});
}

ScanNode makeNode(int number, PlaceId place) {
  ScanNode node;
  node.stamp = std::chrono::nanoseconds(1000 + number);
  node.odom_from_base = {0.5 * number, 1.0, -0.25};
  node.first_way = number - 1.5;
  node.last_way = number + 1.5;
  node.session = 1;
  node.pose = {number + 0.125, -2.0, 0.5};
  if (number > 0) node.before = static_cast<NodeIndex>(number - 1);
  node.motion = {0.5, 0.0, 0.0625};
  node.motion_way = 0.5;
  node.motion_turn = 6.5;
  if (number != 1) node.compass = 0.75;
  node.place = place;
  if (number != 3) node.readings = makeReadings(1.0 + 0.5 * number);
  return node;
}

// Four scans, of which the first is place 1.
KeptMap makeScans() {
  KeptMap map;
  for (int number = 0; number < 4; ++number) {
    map.nodes.push_back(makeNode(number, number == 0 ? 1 : kNoPlace));
  }
  for (const NodeIndex node : {NodeIndex{2}, NodeIndex{3}}) {
    Tie tie;
    tie.place = 0;
    tie.node = node;
    tie.relative = {1.0, 0.5, -0.125};
    tie.information << 400.0, 1.0, 2.0, 1.0, 300.0, 3.0, 2.0, 3.0, 900.0;
    tie.closure = static_cast<int>(node);
    map.ties.push_back(tie);
  }
  map.errors = {0.03, -0.02};
  return map;
}

void expectSame(const ScanNode& one, const ScanNode& other) {
  EXPECT_EQ(one.stamp, other.stamp);
  EXPECT_EQ(one.odom_from_base, other.odom_from_base);
  EXPECT_EQ(one.first_way, other.first_way);
  EXPECT_EQ(one.last_way, other.last_way);
  EXPECT_EQ(one.session, other.session);
  EXPECT_EQ(one.pose, other.pose);
  EXPECT_EQ(one.before, other.before);
  EXPECT_EQ(one.motion, other.motion);
  EXPECT_EQ(one.motion_way, other.motion_way);
  EXPECT_EQ(one.motion_turn, other.motion_turn);
  EXPECT_EQ(one.compass, other.compass);
  EXPECT_EQ(one.place, other.place);
  ASSERT_EQ(one.readings == nullptr, other.readings == nullptr);
  if (!one.readings) return;
  ASSERT_EQ(one.readings->size(), other.readings->size());
  for (std::size_t i = 0; i < one.readings->size(); ++i) {
    EXPECT_EQ((*one.readings)[i].sensor_pose, (*other.readings)[i].sensor_pose);
    EXPECT_EQ((*one.readings)[i].range, (*other.readings)[i].range);
  }
}

class StoreScansTest : public PlaceStoreTest {
 protected:
  void keep(const KeptMap& scans) const {
    PlaceStore store = open();
    MapChange change;
    change.version = store.map().version() + 1;
    store.commit(change, scans);
  }
};

TEST_F(StoreScansTest, KeepsScansTiesAndErrorsOfTheWheels) {
  fill();
  keep(makeScans());
  const PlaceStore store = open();
  const KeptMap found = store.scans();
  const KeptMap wanted = makeScans();
  ASSERT_EQ(found.nodes.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) expectSame(found.nodes[i], wanted.nodes[i]);
  ASSERT_EQ(found.ties.size(), 2U);
  EXPECT_EQ(found.ties[1].node, 3U);
  EXPECT_EQ(found.ties[1].relative, wanted.ties[1].relative);
  EXPECT_EQ(found.ties[1].information, wanted.ties[1].information);
  EXPECT_EQ(found.ties[1].closure, 3);
  EXPECT_EQ(found.errors.bend, 0.03);
  EXPECT_EQ(found.errors.turn_factor, -0.02);
  EXPECT_EQ(found.next_place, 4);
  EXPECT_TRUE(store.setAside().empty());
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(StoreScansTest, TakeThePlaceOfThoseBefore) {
  fill();
  keep(makeScans());
  KeptMap fewer = makeScans();
  fewer.nodes.resize(2);
  fewer.nodes[1].pose.x = 9.0;
  fewer.ties.clear();
  keep(fewer);
  const PlaceStore store = open();
  const KeptMap found = store.scans();
  ASSERT_EQ(found.nodes.size(), 2U);
  EXPECT_EQ(found.nodes[1].pose.x, 9.0);
  EXPECT_TRUE(found.ties.empty());
  EXPECT_TRUE(store.setAside().empty());
}

TEST_F(StoreScansTest, OfAPlaceThatIsGoneAreNoPlace) {
  fill();
  keep(makeScans());
  PlaceStore store = open();
  commit(store, {PlaceRemoved{1}});
  EXPECT_EQ(store.scans().nodes.front().place, kNoPlace);
}

TEST_F(StoreScansTest, GoWithTheMap) {
  fill();
  keep(makeScans());
  PlaceStore store = open();
  commit(store, {MapCleared{}});
  EXPECT_TRUE(store.scans().nodes.empty());
  EXPECT_TRUE(store.scans().ties.empty());
  EXPECT_TRUE(store.setAside().empty());
}

TEST_F(StoreScansTest, ADamagedScanIsLeftOutWithItsTies) {
  fill();
  keep(makeScans());
  runSql(path_, "UPDATE node SET x = x + 1 WHERE id = 2");
  const PlaceStore store = open();
  const KeptMap found = store.scans();
  ASSERT_EQ(found.nodes.size(), 3U);
  EXPECT_EQ(found.nodes[2].stamp.count(), 1003);
  EXPECT_FALSE(found.nodes[2].before.has_value());
  ASSERT_EQ(found.ties.size(), 1U);
  EXPECT_EQ(found.ties[0].node, 2U);
  ASSERT_EQ(store.setAside().size(), 1U);
  EXPECT_NE(store.setAside()[0].find("1 scans of drives are damaged"), std::string::npos);
}

TEST_F(StoreScansTest, MissingRowsAreNoticed) {
  fill();
  keep(makeScans());
  runSql(path_, "DELETE FROM node WHERE id = 3; DELETE FROM tie WHERE id = 1");
  const PlaceStore store = open();
  ASSERT_EQ(store.setAside().size(), 2U);
  EXPECT_EQ(store.setAside()[0], "1 scans of drives are missing");
  EXPECT_EQ(store.setAside()[1], "1 ties of scans are missing");
}

TEST_F(StoreScansTest, AStoreOfFormat3IsBroughtToThisOneAndKeptBesideIt) {
  fill();
  const PlaceIdentity identity = open().identity();
  const std::vector<Place> places = open().map().places();
  makeFormat3(path_);
  const std::string before = readFile(path_);
  std::string said;
  StoreOpening opening;
  opening.progress = [&](const std::string& sentence) { said += sentence; };
  {
    const PlaceStore store(path_, kDefaultCellSize, opening);
    EXPECT_EQ(store.identity(), identity);
    EXPECT_EQ(store.map().places(), places);
    EXPECT_EQ(store.map().links().size(), 2U);
    EXPECT_EQ(store.grid(2), makeGrid(2));
    EXPECT_TRUE(store.scans().nodes.empty());
    EXPECT_TRUE(store.setAside().empty());
    EXPECT_EQ(store.nextId(), 4);
  }
  EXPECT_NE(said.find("kept as " + path_ + ".format-3"), std::string::npos) << said;
  EXPECT_EQ(readFile(path_ + ".format-3"), before);
  keep(makeScans());
  EXPECT_EQ(open().scans().nodes.size(), 4U);
}

TEST_F(StoreScansTest, AStoreOfFormat3WithOtherCellsIsLeftAsItIs) {
  fill();
  makeFormat3(path_);
  const std::string before = readFile(path_);
  EXPECT_THROW(PlaceStore(path_, 2.0 * kDefaultCellSize), StoreError);
  EXPECT_EQ(readFile(path_), before);
  EXPECT_FALSE(std::filesystem::exists(path_ + ".format-3"));
}

TEST_F(StoreScansTest, ADamagedRowOfFormat3IsNamedAfterItWasBroughtOver) {
  fill();
  makeFormat3(path_);
  runSql(path_, "UPDATE place SET x = 100 WHERE id = 2");
  const PlaceStore store = open();
  EXPECT_EQ(store.map().size(), 2U);
  ASSERT_FALSE(store.setAside().empty());
  EXPECT_NE(store.setAside()[0].find("place 2 is damaged"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::core
