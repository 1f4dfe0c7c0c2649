#ifndef PLACE_MEMORY_CORE_SENSING_NEWEST_STAMPS_H
#define PLACE_MEMORY_CORE_SENSING_NEWEST_STAMPS_H

#include <chrono>
#include <map>

#include "core/sensing/heading_history.h"
#include "core/sensing/measurement.h"

namespace place_memory::core {

/// The newest stamp of each sensor, by which a stale one shows: a board that restarted says 1970.
/// A sensor whose clock is behind that of the others is not stale.
class NewestStamps {
 public:
  /// How the stamp follows the newest one of its sensor.
  TimeOrder note(SensorId sensor, std::chrono::nanoseconds stamp);
  /// Of a sensor that was noted before.
  std::chrono::nanoseconds newest(SensorId sensor) const { return newest_.at(sensor); }
  void clear() { newest_.clear(); }

 private:
  std::map<SensorId, std::chrono::nanoseconds> newest_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_NEWEST_STAMPS_H
