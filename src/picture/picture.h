#ifndef PLACE_MEMORY_PICTURE_PICTURE_H
#define PLACE_MEMORY_PICTURE_PICTURE_H

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace place_memory::picture {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Color& other) const {
    return red == other.red && green == other.green && blue == other.blue;
  }
};

/// In metres, x to the right and y up, as are all lengths in a picture.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// From point to point, with round ends and corners.
struct Line {
  std::vector<Point> points;
  double width = 0.0;
  Color color;
};

struct Disc {
  Point centre;
  double radius = 0.0;
  Color fill;
  std::string hint;  ///< shown where the mouse rests, in SVG
};

/// Begins at `at` on the base line. A white rim makes it readable on anything.
struct Text {
  Point at;
  double size = 0.0;  ///< of the font: capitals are about 0.7 of it high
  std::string text;
  Color color;
};

/// As wide as this text is drawn in an image, and about so in SVG.
double widthOf(const std::string& text, double size);

/// Cells, row by row from the lower left corner.
struct Raster {
  Point corner;
  double cell = 0.0;
  int columns = 0;
  int rows = 0;
  std::vector<Color> colors;
};

using Shape = std::variant<Raster, Line, Disc, Text>;

/// What was drawn last covers what was drawn before.
struct Picture {
  Point lower_left;
  Point upper_right;
  Color background{255, 255, 255};
  std::vector<Shape> shapes;
};

/// An element to be put in a page, of the CSS class `name`.
std::string toSvg(const Picture& picture, const std::string& name);

/// The longer side of the image has `pixels`, > 0.
std::string toPng(const Picture& picture, int pixels);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_PICTURE_H
