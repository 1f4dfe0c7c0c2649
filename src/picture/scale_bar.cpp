#include "picture/scale_bar.h"

#include <algorithm>
#include <cmath>

#include "picture/svg_text.h"

namespace place_memory::picture {
namespace {

constexpr Color kInk{25, 30, 60};
constexpr double kShare = 0.2;  // of the picture, at most

double roundLength(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= most) return factor * decade;
  }
  return decade;
}

}  // namespace

void addScaleBar(Picture& picture, double letters) {
  const double size = std::max(picture.upper_right.x - picture.lower_left.x,
                               picture.upper_right.y - picture.lower_left.y);
  const double length = roundLength(kShare * size);
  const double x = picture.lower_left.x + 0.6 * letters;
  const double y = picture.lower_left.y + 0.6 * letters;
  picture.shapes.emplace_back(Line{{{x, y}, {x + length, y}}, 0.15 * letters, kInk});
  picture.shapes.emplace_back(
      Text{{x, y + 0.3 * letters}, letters, decimal(length, length < 1.0 ? 1 : 0) + " m", kInk});
}

}  // namespace place_memory::picture
