#ifndef PLACE_MEMORY_CORE_SENSING_LISTENING_END_H
#define PLACE_MEMORY_CORE_SENSING_LISTENING_END_H

#include <chrono>
#include <cstddef>

#include "core/sensing/sweep_builder.h"

namespace place_memory::core {

/// When a sweep is over whose turn is somebody else's.
class ListeningEnd {
 public:
  /// `start` of the sweep; it is not over with fewer readings.
  ListeningEnd(std::chrono::nanoseconds start, std::size_t min_readings)
      : last_reading_(start), min_readings_(min_readings) {}

  /// Told again and again. The sweep is over once every heading is; or all were sensed and the
  /// sensors have been silent for half a second, and for twice as long as ever before in the sweep,
  /// though not every one of them spoke at the last heading.
  bool update(std::chrono::nanoseconds now, const SweepBuilder& sweep);

 private:
  std::size_t readings_ = 0;  // there were when last_reading_ was
  std::chrono::nanoseconds last_reading_;
  std::size_t min_readings_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_LISTENING_END_H
