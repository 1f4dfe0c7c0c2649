#include "core/sensing/scan_changes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kDoor = 1.2;    // before the robot [m]
constexpr double kBehind = 3.0;  // to what stands behind the door [m]

/// Sonars that look at a doorway before them. Through an open one they hear what is behind it with
/// two readings of five; with the rest, and all where it is closed, an echo from where the door is.
std::vector<SonarReading> doorway(bool open) {
  std::vector<SonarReading> readings;
  for (int i = -12; i <= 12; ++i) {
    SonarReading reading;
    reading.sensor_pose = {0.0, 0.0, i * kDegree};
    reading.spec = {25.0 * kDegree, 0.15, 4.5};
    reading.range = open && (i + 15) % 5 % 3 == 1 ? kBehind : kDoor;
    readings.push_back(reading);
  }
  return readings;
}

std::vector<GridChange> changes(bool was_open, bool is_open) {
  return changesBetween(doorway(was_open), doorway(is_open), SonarModelOptions{}, GridGeometry{});
}

/// Whether one of them is such a change at the door.
bool isAtDoor(const std::vector<GridChange>& found, bool appeared) {
  for (const GridChange& change : found) {
    const double way = std::hypot(change.x - kDoor, change.y);
    if (change.appeared == appeared && way < 0.3) return true;
  }
  return false;
}

TEST(ScanChanges, ADoorThatOpensIsGoneThoughItsJambsEcho) {
  EXPECT_TRUE(isAtDoor(changes(false, true), false));
  EXPECT_FALSE(isAtDoor(changes(false, true), true));
}

TEST(ScanChanges, ADoorThatClosesAppears) {
  EXPECT_TRUE(isAtDoor(changes(true, false), true));
  EXPECT_FALSE(isAtDoor(changes(true, false), false));
}

TEST(ScanChanges, NothingIsTheSame) {
  EXPECT_TRUE(changes(true, true).empty());
  EXPECT_TRUE(changes(false, false).empty());
}

TEST(ScanChanges, NoReadingsSayNothing) {
  EXPECT_TRUE(changesBetween({}, doorway(true), SonarModelOptions{}, GridGeometry{}).empty());
  EXPECT_TRUE(changesBetween(doorway(true), {}, SonarModelOptions{}, GridGeometry{}).empty());
}

TEST(ScanChanges, GridsOfPlacesWouldNotTellTheDoor) {
  const SonarModel sonar(SonarModelOptions{});
  const GridGeometry geometry;
  EXPECT_FALSE(isAtDoor(
      changesBetween(sonar.build(doorway(false), geometry), sonar.build(doorway(true), geometry)),
      false));
}

}  // namespace
}  // namespace place_memory::core
