// Draws a picture pixel by pixel. Of a pixel that a shape covers in part, it takes that part.
#include <algorithm>
#include <cmath>

#include "picture/line_font.h"
#include "picture/picture.h"
#include "picture/png.h"

namespace place_memory::picture {
namespace {

constexpr double kStroke = 0.09;      // width of a letter's lines, of a font of size 1
constexpr double kLeastStroke = 1.2;  // [pixels]

std::uint8_t blended(std::uint8_t under, std::uint8_t over, double share) {
  return static_cast<std::uint8_t>(std::lround(under + share * (over - under)));
}

double distanceToSegment(const Point& from, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along = squared == 0.0 ? 0.0 : ((from.x - a.x) * dx + (from.y - a.y) * dy) / squared;
  const double held = std::clamp(along, 0.0, 1.0);
  return std::hypot(from.x - a.x - held * dx, from.y - a.y - held * dy);
}

class Canvas {
 public:
  Canvas(const Picture& picture, int pixels) {
    const double width = picture.upper_right.x - picture.lower_left.x;
    const double height = picture.upper_right.y - picture.lower_left.y;
    scale_ = pixels / std::max({width, height, 1e-9});
    left_ = picture.lower_left.x;
    top_ = picture.upper_right.y;
    width_ = std::max(1, static_cast<int>(std::lround(scale_ * width)));
    height_ = std::max(1, static_cast<int>(std::lround(scale_ * height)));
    pixels_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                   picture.background);
  }

  void operator()(const Raster& raster);
  void operator()(const Line& line) { stroke(line.points, 0.5 * line.width * scale_, line.color); }
  void operator()(const Disc& disc) { stroke({disc.centre}, disc.radius * scale_, disc.fill); }
  void operator()(const Text& text) {
    const double radius = 0.5 * std::max(kStroke * text.size * scale_, kLeastStroke);
    for (std::vector<Point> points : strokes(text.text)) {
      for (Point& point : points) {
        point = {text.at.x + text.size * point.x, text.at.y + text.size * point.y};
      }
      stroke(points, radius, text.color);
    }
  }

  std::string png() const { return encodePng(pixels_, width_); }

 private:
  /// In pixels, from the upper left corner.
  Point toPixels(const Point& point) const {
    return {(point.x - left_) * scale_, (top_ - point.y) * scale_};
  }
  Color& at(int column, int row) {
    return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(column)];
  }
  void stroke(const std::vector<Point>& points, double radius, const Color& color);
  void capsule(const Point& a, const Point& b, double radius, const Color& color);

  double scale_ = 1.0;  ///< [pixels/m]
  double left_ = 0.0;
  double top_ = 0.0;
  int width_ = 1;
  int height_ = 1;
  std::vector<Color> pixels_;
};

void Canvas::stroke(const std::vector<Point>& points, double radius, const Color& color) {
  if (points.empty()) return;
  Point before = toPixels(points.front());
  if (points.size() == 1) capsule(before, before, radius, color);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point next = toPixels(points[i]);
    capsule(before, next, radius, color);
    before = next;
  }
}

void Canvas::capsule(const Point& a, const Point& b, double radius, const Color& color) {
  const double reach = radius + 1.0;
  const auto bound = [](double coordinate, int end) {
    return static_cast<int>(std::clamp(std::floor(coordinate), 0.0, static_cast<double>(end)));
  };
  const int last_row = bound(std::max(a.y, b.y) + reach, height_ - 1);
  const int last_column = bound(std::max(a.x, b.x) + reach, width_ - 1);
  for (int row = bound(std::min(a.y, b.y) - reach, height_); row <= last_row; ++row) {
    for (int column = bound(std::min(a.x, b.x) - reach, width_); column <= last_column; ++column) {
      const double distance = distanceToSegment({column + 0.5, row + 0.5}, a, b);
      const double share = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
      if (share == 0.0) continue;
      Color& pixel = at(column, row);
      pixel = {blended(pixel.red, color.red, share), blended(pixel.green, color.green, share),
               blended(pixel.blue, color.blue, share)};
    }
  }
}

// A pixel that covers several cells has their mean.
void Canvas::operator()(const Raster& raster) {
  const double cells = 1.0 / (scale_ * raster.cell);  // along a pixel
  for (int row = 0; row < height_; ++row) {
    const double y = (top_ - raster.corner.y - (row + 1) / scale_) / raster.cell;
    const int first_row = static_cast<int>(std::floor(y + 0.5 * std::min(cells, 1.0)));
    const int last_row = std::max(first_row, static_cast<int>(std::ceil(y + cells - 0.5)) - 1);
    if (last_row < 0 || first_row >= raster.rows) continue;
    for (int column = 0; column < width_; ++column) {
      const double x = (left_ - raster.corner.x + column / scale_) / raster.cell;
      const int first = static_cast<int>(std::floor(x + 0.5 * std::min(cells, 1.0)));
      const int last = std::max(first, static_cast<int>(std::ceil(x + cells - 0.5)) - 1);
      int red = 0, green = 0, blue = 0, count = 0;
      for (int i = std::max(first_row, 0); i <= std::min(last_row, raster.rows - 1); ++i) {
        for (int j = std::max(first, 0); j <= std::min(last, raster.columns - 1); ++j) {
          const Color& color =
              raster.colors[static_cast<std::size_t>(i) * static_cast<std::size_t>(raster.columns) +
                            static_cast<std::size_t>(j)];
          red += color.red;
          green += color.green;
          blue += color.blue;
          ++count;
        }
      }
      if (count == 0) continue;
      at(column, row) = {static_cast<std::uint8_t>(red / count),
                         static_cast<std::uint8_t>(green / count),
                         static_cast<std::uint8_t>(blue / count)};
    }
  }
}

}  // namespace

std::string toPng(const Picture& picture, int pixels) {
  Canvas canvas(picture, pixels);
  for (const Shape& shape : picture.shapes) std::visit(canvas, shape);
  return canvas.png();
}

}  // namespace place_memory::picture
