#ifndef PLACE_MEMORY_CORE_STORE_PACKED_READINGS_H
#define PLACE_MEMORY_CORE_STORE_PACKED_READINGS_H

#include <cstddef>
#include <optional>
#include <vector>

#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// The readings of a scan in 18 bytes each: single precision, which is some micrometres within a
/// grid, and each kind of sonar once.
std::vector<unsigned char> packReadings(const std::vector<SonarReading>& readings);

/// Nothing where the bytes are no such readings.
std::optional<std::vector<SonarReading>> unpackReadings(const void* bytes, std::size_t size);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PACKED_READINGS_H
