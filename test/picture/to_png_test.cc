#include <gtest/gtest.h>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <sstream>

#include "picture/picture.h"

namespace place_memory::picture {
namespace {

constexpr Color kRed{255, 0, 0};
constexpr Color kBlue{0, 0, 255};
constexpr Color kWhite{255, 255, 255};

/// What a viewer sees.
class Image {
 public:
  explicit Image(const std::string& png) {
    namespace io = boost::iostreams;
    width_ = numberAt(png, 16);
    height_ = numberAt(png, 20);
    const std::size_t data = png.find("IDAT");
    std::istringstream source(png.substr(data + 4, numberAt(png, data - 4)));
    std::ostringstream result;
    io::filtering_istream stream;
    stream.push(io::zlib_decompressor());
    stream.push(source);
    io::copy(stream, result);
    bytes_ = result.str();
  }

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  Color at(std::size_t column, std::size_t row) const {
    const std::size_t i = row * (3 * width_ + 1) + 1 + 3 * column;
    return {static_cast<std::uint8_t>(bytes_.at(i)), static_cast<std::uint8_t>(bytes_.at(i + 1)),
            static_cast<std::uint8_t>(bytes_.at(i + 2))};
  }

 private:
  static std::size_t numberAt(const std::string& bytes, std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      number = 256 * number + static_cast<unsigned char>(bytes[at + i]);
    }
    return number;
  }

  std::size_t width_, height_;
  std::string bytes_;
};

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
  EXPECT_EQ(image.at(50, 28).red, 127 + 1);
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
  EXPECT_EQ(mixed.red, 127);
  EXPECT_EQ(mixed.blue, 127);
}

TEST(ToPng, TextIsReadable) {
  const Image image = draw({Text{{0.0, 2.0}, 2.0, "L", kBlue}});
  EXPECT_LT(image.at(20, 38).red, 60);  // the stem and the foot
  EXPECT_LT(image.at(20, 28).red, 60);
  EXPECT_LT(image.at(28, 39).red, 60);
  EXPECT_EQ(image.at(28, 30), kWhite);
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
