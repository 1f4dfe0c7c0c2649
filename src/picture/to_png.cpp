// Draws a picture in an image.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "picture/picture.h"
#include "picture/surface.h"
#include "place_memory/core/pose2d.h"
#include "support/text.h"

namespace place_memory::picture {
namespace {

constexpr double kRim = 1.5;  // of white around a letter [pixels]
constexpr Color kWhite{255, 255, 255};

class Canvas {
 public:
  Canvas(const Picture& picture, int pixels) {
    const double width = picture.upper_right.x - picture.lower_left.x;
    const double height = picture.upper_right.y - picture.lower_left.y;
    scale_ = pixels / std::max({width, height, 1e-9});
    left_ = picture.lower_left.x;
    top_ = picture.upper_right.y;
    surface_ = makeSurface(std::max(1, static_cast<int>(std::lround(scale_ * width))),
                           std::max(1, static_cast<int>(std::lround(scale_ * height))),
                           picture.background);
    context_.reset(cairo_create(surface_.get()));
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  }

  void operator()(const Raster& raster);
  void operator()(const Line& line);
  void operator()(const Disc& disc);
  void operator()(const Text& text);

  std::string png() {
    cairo_surface_flush(surface_.get());
    return encodePng(*surface_);
  }

 private:
  /// In pixels, from the upper left corner.
  Point toPixels(const Point& point) const {
    return {(point.x - left_) * scale_, (top_ - point.y) * scale_};
  }
  void choose(const Color& color) {
    cairo_set_source_rgb(context_.get(), color.red / 255.0, color.green / 255.0,
                         color.blue / 255.0);
  }

  double scale_ = 1.0;  ///< [pixels/m]
  double left_ = 0.0;
  double top_ = 0.0;
  Surface surface_;
  Context context_;
};

void Canvas::operator()(const Line& line) {
  for (const Point& point : line.points) {
    const Point at = toPixels(point);
    cairo_line_to(context_.get(), at.x, at.y);
  }
  choose(line.color);
  cairo_set_line_width(context_.get(), line.width * scale_);
  cairo_stroke(context_.get());
}

void Canvas::operator()(const Disc& disc) {
  const Point at = toPixels(disc.centre);
  choose(disc.fill);
  cairo_arc(context_.get(), at.x, at.y, disc.radius * scale_, 0.0, 2.0 * core::kPi);
  cairo_fill(context_.get());
}

void Canvas::operator()(const Text& text) {
  const Point at = toPixels(text.at);
  chooseFont(*context_, text.size * scale_);
  cairo_move_to(context_.get(), at.x, at.y);
  cairo_text_path(context_.get(), support::printable(text.text).c_str());
  choose(kWhite);
  cairo_set_line_width(context_.get(), 2.0 * kRim);
  cairo_stroke_preserve(context_.get());
  choose(text.color);
  cairo_fill(context_.get());
}

// Cells that are smaller than a pixel are mixed.
void Canvas::operator()(const Raster& raster) {
  if (raster.colors.empty()) return;
  std::vector<Color> pixels;
  pixels.reserve(raster.colors.size());
  for (auto row = raster.colors.end(); row != raster.colors.begin(); row -= raster.columns) {
    pixels.insert(pixels.end(), row - raster.columns, row);
  }
  const Surface cells = makeSurface(pixels, raster.columns);
  const Point corner = toPixels({raster.corner.x, raster.corner.y + raster.rows * raster.cell});
  const double size = raster.cell * scale_;
  cairo_save(context_.get());
  cairo_translate(context_.get(), corner.x, corner.y);
  cairo_scale(context_.get(), size, size);
  cairo_set_source_surface(context_.get(), cells.get(), 0.0, 0.0);
  cairo_pattern_t* const source = cairo_get_source(context_.get());
  cairo_pattern_set_filter(source, size < 1.0 ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_pattern_set_extend(source, CAIRO_EXTEND_PAD);
  cairo_rectangle(context_.get(), 0.0, 0.0, raster.columns, raster.rows);
  cairo_fill(context_.get());
  cairo_restore(context_.get());
}

}  // namespace

std::string toPng(const Picture& picture, int pixels) {
  Canvas canvas(picture, pixels);
  for (const Shape& shape : picture.shapes) std::visit(canvas, shape);
  return canvas.png();
}

}  // namespace place_memory::picture
