#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "picture/picture.h"
#include "picture/surface.h"
#include "picture/svg_text.h"

namespace place_memory::picture {
namespace {

std::string base64(std::string bytes) {
  using Sixes = boost::archive::iterators::transform_width<std::string::const_iterator, 6, 8>;
  using Letters = boost::archive::iterators::base64_from_binary<Sixes>;
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.append(missing, '\0');  // reading by sixes ends with whole letters
  std::string text(Letters(bytes.cbegin()), Letters(bytes.cend()));
  return text.replace(text.size() - missing, missing, missing, '=');
}

/// y grows downwards in SVG.
struct SvgWriter {
  std::string text;

  void operator()(const Raster& raster) {
    std::vector<Color> pixels;
    pixels.reserve(raster.colors.size());
    const auto columns = static_cast<std::ptrdiff_t>(raster.columns);
    for (std::ptrdiff_t row = raster.rows - 1; row >= 0; --row) {
      const auto begin = raster.colors.begin() + row * columns;
      pixels.insert(pixels.end(), begin, begin + columns);
    }
    text += "<image x=\"" + decimal(raster.corner.x, 3) + "\" y=\"" +
            decimal(-raster.corner.y - raster.rows * raster.cell, 3) + "\" width=\"" +
            decimal(raster.columns * raster.cell, 3) + "\" height=\"" +
            decimal(raster.rows * raster.cell, 3) +
            "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
            base64(encodePng(*makeSurface(pixels, raster.columns))) + "\"/>";
  }

  void operator()(const Line& line) {
    if (line.points.size() == 2) {
      const Point& a = line.points.front();
      const Point& b = line.points.back();
      text += "<line x1=\"" + decimal(a.x, 3) + "\" y1=\"" + decimal(-a.y, 3) + "\" x2=\"" +
              decimal(b.x, 3) + "\" y2=\"" + decimal(-b.y, 3) + "\"";
    } else {
      text += "<polyline fill=\"none\" points=\"";
      for (const Point& point : line.points) {
        text += decimal(point.x, 3) + "," + decimal(-point.y, 3) + " ";
      }
      text += "\"";
    }
    text += " stroke=\"" + hex(line.color) + "\" stroke-width=\"" + decimal(line.width, 4) +
            "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>";
  }

  void operator()(const Disc& disc) {
    text += "<circle cx=\"" + decimal(disc.centre.x, 3) + "\" cy=\"" + decimal(-disc.centre.y, 3) +
            "\" r=\"" + decimal(disc.radius, 4) + "\" fill=\"" + hex(disc.fill) + "\">" +
            (disc.hint.empty() ? std::string() : hint(disc.hint)) + "</circle>";
  }

  void operator()(const Text& label) {
    text += "<text x=\"" + decimal(label.at.x, 3) + "\" y=\"" + decimal(-label.at.y, 3) +
            "\" font-size=\"" + decimal(label.size, 4) + "\" fill=\"" + hex(label.color) +
            "\" stroke=\"#ffffff\" stroke-width=\"" + decimal(0.15 * label.size, 4) +
            "\" paint-order=\"stroke\">" + escaped(label.text) + "</text>";
  }
};

}  // namespace

std::string toSvg(const Picture& picture, const std::string& name) {
  const double width = picture.upper_right.x - picture.lower_left.x;
  const double height = picture.upper_right.y - picture.lower_left.y;
  SvgWriter writer;
  for (const Shape& shape : picture.shapes) std::visit(writer, shape);
  return "<svg class=\"" + name + "\" viewBox=\"" + decimal(picture.lower_left.x, 3) + " " +
         decimal(-picture.upper_right.y, 3) + " " + decimal(width, 3) + " " + decimal(height, 3) +
         "\" style=\"background: " + hex(picture.background) + "\">" + writer.text + "</svg>\n";
}

}  // namespace place_memory::picture
