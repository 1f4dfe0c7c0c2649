#include "picture/label_layout.h"

#include <algorithm>

namespace place_memory::picture {

LabelLayout::LabelLayout(const std::vector<Point>& discs, double radius, double size)
    : radius_(radius), size_(size) {
  for (const Point& disc : discs) {
    taken_.push_back({disc.x - radius, disc.y - radius, disc.x + radius, disc.y + radius});
  }
}

std::optional<Point> LabelLayout::place(const Point& disc, const std::string& label) {
  const double width = widthOf(label, size_);
  const double height = 0.7 * size_;  // of capitals
  const double gap = 0.4 * radius_;
  const double right = disc.x + radius_ + gap;
  const double left = disc.x - radius_ - gap - width;
  const double middle = disc.y - 0.5 * height;
  const Point spots[] = {{right, disc.y + 0.3 * radius_},
                         {right, middle},
                         {disc.x - 0.5 * width, disc.y + radius_ + gap},
                         {disc.x - 0.5 * width, disc.y - radius_ - gap - height},
                         {left, middle}};
  for (const Point& spot : spots) {
    const Box box{spot.x, spot.y - 0.2 * size_, spot.x + width, spot.y + height};
    if (std::any_of(taken_.begin(), taken_.end(),
                    [&](const Box& other) { return box.overlaps(other); })) {
      continue;
    }
    taken_.push_back(box);
    return spot;
  }
  return std::nullopt;
}

}  // namespace place_memory::picture
