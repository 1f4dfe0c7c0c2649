#ifndef PLACE_MEMORY_CORE_MAPPING_SEEN_MIDDLE_H
#define PLACE_MEMORY_CORE_MAPPING_SEEN_MIDDLE_H

#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// The middle of what readings show, in the base's frame; its yaw is 0. Sonars that look all ways
/// show what is about the base: then it is the base. Those that look ahead show what lies before
/// it, and a robot that comes the other way sees that from beyond: the two see the same where the
/// middles are near, not where the bases are.
Pose2d seenMiddle(const std::vector<SonarReading>& readings);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_SEEN_MIDDLE_H
