#include "core/explore/new_ground.h"

#include <algorithm>

namespace place_memory::core {

void NewGround::note(double way, double area) {
  if (area <= (1.0 + options_.growth) * area_) return;
  way_ = way;
  area_ = area;
}

bool NewGround::isInVain(double way) const {
  return way - way_ > std::max(options_.least, options_.share * way_);
}

}  // namespace place_memory::core
