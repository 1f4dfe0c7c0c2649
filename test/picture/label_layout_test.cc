#include "picture/label_layout.h"

#include <gtest/gtest.h>

namespace place_memory::picture {
namespace {

TEST(LabelLayout, ALabelStandsToTheRightWhereThereIsRoom) {
  LabelLayout layout({{0.0, 0.0}}, 0.2, 0.4);
  const auto spot = layout.place({0.0, 0.0}, "hall");
  ASSERT_TRUE(spot);
  EXPECT_GT(spot->x, 0.2);
  EXPECT_LT(spot->x, 0.4);
}

TEST(LabelLayout, ItGivesWayToADisc) {
  LabelLayout layout({{0.0, 0.0}, {0.6, 0.0}}, 0.2, 0.4);
  const auto spot = layout.place({0.0, 0.0}, "hall");
  ASSERT_TRUE(spot);
  const double right = spot->x + widthOf("hall", 0.4);
  EXPECT_TRUE(right < 0.4 || spot->y > 0.2 || spot->y + 0.28 < -0.2);
}

TEST(LabelLayout, WhereThereIsNoRoomThereIsNoLabel) {
  std::vector<Point> discs;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) discs.push_back({0.3 * i, 0.3 * j});
  }
  LabelLayout crowded(discs, 0.2, 0.4);
  EXPECT_FALSE(crowded.place({0.0, 0.0}, "hall"));
}

TEST(LabelLayout, LabelsDoNotCoverEachOther) {
  LabelLayout layout({{0.0, 0.0}}, 0.2, 0.4);
  std::vector<Point> spots;
  for (int i = 0; i < 10; ++i) {
    if (const auto spot = layout.place({0.0, 0.0}, "hall")) spots.push_back(*spot);
  }
  EXPECT_GE(spots.size(), 3U);
  EXPECT_LE(spots.size(), 5U);
  const double width = widthOf("hall", 0.4);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(std::abs(spots[i].x - spots[j].x) >= width ||
                  std::abs(spots[i].y - spots[j].y) >= 0.28);
    }
  }
}

}  // namespace
}  // namespace place_memory::picture
