#include <gtest/gtest.h>

#include "picture/decoded_image.h"
#include "picture/picture.h"

namespace place_memory::picture {
namespace {

constexpr Color kRed{255, 0, 0};
constexpr Color kBlue{0, 0, 255};
constexpr Color kWhite{255, 255, 255};

/// Ten metres wide and five high, ten pixels a metre.
Image draw(std::vector<Shape> shapes) {
  Picture picture{{-2.0, 1.0}, {8.0, 6.0}, kWhite, std::move(shapes)};
  return Image(toPng(picture, 100));
}

TEST(ToPng, IsAsLargeAsAskedFor) {
  const Image image = draw({});
  EXPECT_EQ(image.width(), 100U);
  EXPECT_EQ(image.height(), 50U);
  EXPECT_EQ(image.at(0, 0), kWhite);
}

TEST(ToPng, XIsToTheRightAndYUp) {
  const Image image = draw({Disc{{-1.0, 5.0}, 0.5, kRed, ""}});
  EXPECT_EQ(image.at(10, 10), kRed);
  EXPECT_EQ(image.at(10, 16), kWhite);
  EXPECT_EQ(image.at(16, 10), kWhite);
}

TEST(ToPng, WhatIsDrawnLaterCovers) {
  const Image image = draw(
      {Disc{{0.0, 3.0}, 1.0, kRed, ""}, Line{{{-2.0, 3.0}, {8.0, 3.0}, {8.0, 6.0}}, 0.4, kBlue}});
  EXPECT_EQ(image.at(20, 30), kBlue);
  EXPECT_EQ(image.at(20, 25), kRed);
  EXPECT_EQ(image.at(80, 30), kBlue);
  EXPECT_EQ(image.at(99, 10), kBlue);
}

TEST(ToPng, APixelThatIsCoveredInPartTakesThatPart) {
  const Image image = draw({Line{{{-2.0, 3.0}, {8.0, 3.0}}, 0.3, kBlue}});  // three pixels
  EXPECT_EQ(image.at(50, 29).red, 0);
  EXPECT_NEAR(image.at(50, 28).red, 127, 20);
  EXPECT_EQ(image.at(50, 27), kWhite);
}

TEST(ToPng, CellsLieWhereTheyBelong) {
  const Raster raster{{0.0, 2.0}, 1.0, 2, 2, {kRed, kBlue, kWhite, kRed}};
  const Image image = draw({raster});
  EXPECT_EQ(image.at(20, 39), kRed);  // from (0, 2) to (1, 3)
  EXPECT_EQ(image.at(39, 39), kBlue);
  EXPECT_EQ(image.at(20, 29), kWhite);
  EXPECT_EQ(image.at(39, 20), kRed);
  EXPECT_EQ(image.at(40, 30), kWhite);
}

TEST(ToPng, SmallCellsAreMixed) {
  const Raster raster{{0.0, 2.0}, 0.05, 2, 2, {kRed, kBlue, kBlue, kRed}};
  const Image image = draw({raster});
  const Color mixed = image.at(20, 39);
  EXPECT_NEAR(mixed.red, 127, 2);
  EXPECT_NEAR(mixed.blue, 127, 2);
}

TEST(ToPng, TextIsReadable) {
  const Image image = draw({Text{{0.0, 2.0}, 2.0, "L", kBlue}});
  EXPECT_LT(image.at(23, 37).red, 60);  // the stem and the foot
  EXPECT_LT(image.at(23, 28).red, 60);
  EXPECT_LT(image.at(28, 39).red, 60);
  EXPECT_EQ(image.at(29, 30), kWhite);
}

TEST(ToPng, LettersThatAreNoneAreNoHarm) {
  const Image image = draw({Text{{0.0, 2.0}, 2.0, "\xff\n", kBlue},  //
                            Disc{{-1.0, 5.0}, 0.5, kRed, ""}});
  EXPECT_EQ(image.at(10, 10), kRed);
}

TEST(ToPng, WhatLiesOutsideIsLeftOut) {
  const Image image =
      draw({Disc{{-900.0, 3.0}, 1.0, kRed, ""}, Line{{{-50.0, 3.05}, {50.0, 3.05}}, 0.5, kBlue},
            Raster{{100.0, 100.0}, 1.0, 1, 1, {kRed}}});
  EXPECT_EQ(image.at(0, 29), kBlue);
  EXPECT_EQ(image.at(0, 0), kWhite);
}

}  // namespace
}  // namespace place_memory::picture
