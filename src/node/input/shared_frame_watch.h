#ifndef PLACE_MEMORY_NODE_INPUT_SHARED_FRAME_WATCH_H
#define PLACE_MEMORY_NODE_INPUT_SHARED_FRAME_WATCH_H

#include <chrono>
#include <map>

#include "core/sensing/measurement.h"

namespace place_memory::node {

/// Tells that what passes for one sensor, by its topic and frame, is several of them: a driver that
/// reads a ring at once stamps all its readings alike, and each is of another distance.
class SharedFrameWatch {
 public:
  /// Whether it has shown by now, this reading included. Takes as much memory as there are sensors.
  bool note(core::SensorId sensor, std::chrono::nanoseconds stamp, double range);

 private:
  struct Last {
    std::chrono::nanoseconds stamp{0};
    double range = 0.0;
    int shared = 0;  // times that a stamp came again with another range
  };
  std::map<core::SensorId, Last> last_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_SHARED_FRAME_WATCH_H
