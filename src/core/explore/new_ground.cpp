#include "core/explore/new_ground.h"

#include <algorithm>

namespace place_memory::core {

void NewGround::note(double way, double seen) {
  if (seen <= (1.0 + options_.growth) * seen_) return;
  way_ = way;
  seen_ = seen;
}

bool NewGround::isInVain(double way) const {
  return way - way_ > std::max(options_.least, options_.share * way_);
}

}  // namespace place_memory::core
