#include "picture/surface.h"

#include <gtest/gtest.h>

#include <string>

#include "picture/decoded_image.h"

namespace place_memory::picture {
namespace {

TEST(Surface, HoldsThePixelsRowByRow) {
  const Image image(encodePng(*makeSurface({{1, 2, 3}, {255, 0, 7}, {4, 5, 6}, {8, 9, 10}}, 2)));
  ASSERT_EQ(image.width(), 2U);
  ASSERT_EQ(image.height(), 2U);
  EXPECT_EQ(image.at(0, 0), (Color{1, 2, 3}));
  EXPECT_EQ(image.at(1, 0), (Color{255, 0, 7}));
  EXPECT_EQ(image.at(0, 1), (Color{4, 5, 6}));
  EXPECT_EQ(image.at(1, 1), (Color{8, 9, 10}));
}

TEST(Surface, IsOfOneColour) {
  const Image image(encodePng(*makeSurface(3, 1, {7, 8, 9})));
  ASSERT_EQ(image.width(), 3U);
  EXPECT_EQ(image.at(2, 0), (Color{7, 8, 9}));
}

TEST(WidthOf, GrowsWithTextAndSize) {
  EXPECT_EQ(widthOf("", 1.0), 0.0);
  EXPECT_GT(widthOf("m", 1.0), widthOf("i", 1.0));
  EXPECT_NEAR(widthOf("hallhall", 2.0), 4.0 * widthOf("hall", 1.0), 1e-9);
}

TEST(WidthOf, CountsLettersNotBytes) {
  EXPECT_LT(widthOf("\xc3\xbc", 1.0), 1.5 * widthOf("u", 1.0));
}

}  // namespace
}  // namespace place_memory::picture
