#ifndef PLACE_MEMORY_PICTURE_SCALE_BAR_H
#define PLACE_MEMORY_PICTURE_SCALE_BAR_H

#include "picture/picture.h"

namespace place_memory::picture {

/// Draws a line of a round length in the lower left corner, and how long it is, in letters of the
/// size [m].
void addScaleBar(Picture& picture, double letters);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_SCALE_BAR_H
