#ifndef PLACE_MEMORY_PICTURE_LABEL_LAYOUT_H
#define PLACE_MEMORY_PICTURE_LABEL_LAYOUT_H

#include <optional>
#include <string>
#include <vector>

#include "picture/picture.h"

namespace place_memory::picture {

/// Finds room for labels beside discs, so that none covers another one or a disc.
class LabelLayout {
 public:
  /// `radius`: of the discs [m]; `size`: of the font.
  LabelLayout(const std::vector<Point>& discs, double radius, double size);

  /// Where the label of a disc goes, which is taken then; nothing where there is no room.
  std::optional<Point> place(const Point& disc, const std::string& label);

 private:
  struct Box {
    double left, bottom, right, top;
    bool overlaps(const Box& other) const {
      return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
  };

  double radius_;
  double size_;
  std::vector<Box> taken_;
};

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_LABEL_LAYOUT_H
