#include <gtest/gtest.h>

#include "picture/picture.h"

namespace place_memory::picture {
namespace {

constexpr Color kInk{1, 2, 255};

TEST(ToSvg, DrawsEachShapeWhereItLies) {
  Picture picture{{-1.0, -2.0}, {9.0, 3.0}, {255, 255, 255}, {}};
  picture.shapes = {Line{{{1.0, 2.0}, {3.0, 4.0}}, 0.5, kInk},
                    Line{{{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}, 0.5, kInk},
                    Disc{{1.0, 2.0}, 0.25, kInk, "a < b"}, Text{{1.0, 2.0}, 0.5, "a & b", kInk},
                    Raster{{1.0, 2.0}, 0.5, 2, 1, {kInk, kInk}}};
  const std::string svg = toSvg(picture, "map");
  for (const char* text :
       {"<svg class=\"map\" viewBox=\"-1.000 -3.000 10.000 5.000\"",
        "<line x1=\"1.000\" y1=\"-2.000\" x2=\"3.000\" y2=\"-4.000\" stroke=\"#0102ff\"",
        "points=\"1.000,-2.000 3.000,-4.000 5.000,-6.000 \"",
        "<circle cx=\"1.000\" cy=\"-2.000\" r=\"0.2500\"", "<title>a &lt; b</title>",
        "<text x=\"1.000\" y=\"-2.000\"", ">a &amp; b</text>",
        "<image x=\"1.000\" y=\"-2.500\" width=\"1.000\" height=\"0.500\"",
        "href=\"data:image/png;base64,iVBORw0KGgo"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text << " in " << svg;
  }
}

}  // namespace
}  // namespace place_memory::picture
