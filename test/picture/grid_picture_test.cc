#include "picture/grid_picture.h"

#include <gtest/gtest.h>

#include "place_memory/core/pose2d.h"

namespace place_memory::picture {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(ScanPicture, DrawsCellsWhereTheyLie) {
  core::EvidenceGrid grid;
  // Two runs of one row, the first of two cells.
  for (const int column : {40, 41, 50}) grid.add(10, column, 100);
  const std::string picture = scanPicture(grid, {});
  EXPECT_NE(picture.find("M8 -22h2v1h-2zM18 -22h1v1h-1z"), std::string::npos) << picture;
  EXPECT_EQ(picture.find("nan"), std::string::npos);
}

TEST(ScanPicture, OfAnEmptyGridHasNoCells) {
  EXPECT_EQ(count(scanPicture(core::EvidenceGrid(), {}), "<path"), 2U);  // background and robot
}

TEST(PlacePicture, LiesWhereItAligns) {
  core::EvidenceGrid place;
  place.add(0, 0, 100);
  const double cell = place.geometry().cell_size;
  const std::string picture = placePicture(place, {3.0 * cell, -2.0 * cell, 0.0}, {});
  EXPECT_NE(picture.find("matrix(1.00000 0.00000 0.00000 1.00000 -3.000 2.000)"), std::string::npos)
      << picture;
  const std::string turned = placePicture(place, {0.0, 0.0, core::kPi / 2.0}, {});
  EXPECT_NE(turned.find("matrix(0.00000 -1.00000 1.00000 0.00000"), std::string::npos) << turned;
}

TEST(OverlayPicture, ShowsBoth) {
  core::EvidenceGrid scan;
  scan.add(5, 5, 100);
  core::EvidenceGrid place;
  place.add(6, 6, 100);
  const std::string picture = overlayPicture(scan, place, {}, {});
  EXPECT_NE(picture.find("M-27 -27h1"), std::string::npos) << picture;
  EXPECT_NE(picture.find("M-26 -26h1"), std::string::npos) << picture;
}

}  // namespace
}  // namespace place_memory::picture
