#ifndef PLACE_MEMORY_CORE_SENSING_MOVED_READINGS_H
#define PLACE_MEMORY_CORE_SENSING_MOVED_READINGS_H

#include <vector>

#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// The readings as another frame has them.
std::vector<SonarReading> movedReadings(const std::vector<SonarReading>& readings,
                                        const Pose2d& target_from_readings);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_MOVED_READINGS_H
