#include "core/grid/grid_fusion.h"

#include <gtest/gtest.h>

#include "core/random_room.h"
#include "core/sensing/moved_readings.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {
namespace {

constexpr double kRetention = 0.7;

/// What a scan says of one cell: nothing where it is 0.
EvidenceGrid gridOf(int evidence) {
  EvidenceGrid grid;
  grid.add(30, 40, evidence);
  return grid;
}

int fused(int learned, int scan, double retention = kRetention) {
  EvidenceGrid grid = gridOf(learned);
  fuse(gridOf(scan), retention, grid);
  return grid.at(30, 40);
}

TEST(GridFusion, OldEvidenceFadesWhereTheScanSensed) {
  EXPECT_EQ(fused(100, 20), 90);
  EXPECT_EQ(fused(-100, 20), -50);
  EXPECT_EQ(fused(0, 20), 20);
  EXPECT_EQ(fused(100, -20, 0.0), -20);
}

TEST(GridFusion, WhatTheScanDidNotSenseStays) {
  EXPECT_EQ(fused(100, 0), 100);
  EXPECT_EQ(fused(-1, 0, 0.0), -1);
}

TEST(GridFusion, Saturates) {
  EXPECT_EQ(fused(127, 127), 127);
  EXPECT_EQ(fused(-127, -127), -127);
  EXPECT_EQ(fused(-127, 127), 39);
}

TEST(GridFusion, AChairThatStaysAppearsAfterSomeVisits) {
  EvidenceGrid learned = gridOf(-127);
  int visits = 0;
  for (; learned.at(30, 40) <= 0 && visits < 20; ++visits) fuse(gridOf(30), kRetention, learned);
  EXPECT_GT(visits, 1);
  EXPECT_LE(visits, 5);
  for (int i = 0; i < 20; ++i) fuse(gridOf(30), kRetention, learned);
  EXPECT_GT(learned.at(30, 40), 60);
}

TEST(GridFusion, APersonWhoPassedIsForgotten) {
  EvidenceGrid learned = gridOf(-60);
  fuse(gridOf(70), kRetention, learned);
  EXPECT_GT(learned.at(30, 40), 0);
  fuse(gridOf(-60), kRetention, learned);
  EXPECT_LT(learned.at(30, 40), 0);
}

TEST(GridFusion, FadesToNothingInTheEnd) {
  EvidenceGrid learned = gridOf(127);
  // Evidence of one step, there and back, keeps the cell sensed.
  for (int i = 0; i < 60; ++i) fuse(gridOf(i % 2 == 0 ? 1 : -1), 0.9, learned);
  EXPECT_LE(std::abs(learned.at(30, 40)), 1);
}

TEST(GridFusion, ReadingsMovedByNothingAreTheSame) {
  const Scan scan = RandomRoom(1).scanFrom({0.2, 0.1, 0.3});
  const auto moved = movedReadings(scan.readings, Pose2d{});
  EXPECT_EQ(SonarModel(SonarModelOptions{}).build(moved, scan.grid.geometry()), scan.grid);
}

TEST(GridFusion, MovedReadingsSeeTheRoomAsItsOtherFrameDoes) {
  const RandomRoom room(2);
  const Pose2d there{0.35, -0.2, 0.25};
  const EvidenceGrid from_middle = room.scanFrom(Pose2d{}).grid;
  const auto moved = movedReadings(room.scanFrom(there).readings, there);
  const EvidenceGrid from_there = SonarModel(SonarModelOptions{}).build(moved, GridGeometry{});
  int sensed = 0;
  int same = 0;
  for (std::size_t i = 0; i < from_middle.cells().size(); ++i) {
    const int a = from_middle.cells()[i];
    const int b = from_there.cells()[i];
    if (std::abs(a) < 20 || std::abs(b) < 20) continue;
    ++sensed;
    if ((a > 0) == (b > 0)) ++same;
  }
  EXPECT_GT(sensed, 300);
  EXPECT_GT(same, 0.9 * sensed);
}

}  // namespace
}  // namespace place_memory::core
