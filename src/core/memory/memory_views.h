#ifndef PLACE_MEMORY_CORE_MEMORY_MEMORY_VIEWS_H
#define PLACE_MEMORY_CORE_MEMORY_MEMORY_VIEWS_H

#include <chrono>

#include "core/views/view_advice.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

/// What a robot should look at next that may be at several places of the memory, as ViewAdviser has
/// it; by what its links cost at `now`, which they learn by `links`. Lays the whole map out for
/// that, and waits for the disk. Throws PlaceMemoryError.
ViewAdvice adviseView(const PlaceMemory& memory, const LinkLearningOptions& links,
                      std::chrono::nanoseconds now, const ViewQuestion& question);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_MEMORY_VIEWS_H
