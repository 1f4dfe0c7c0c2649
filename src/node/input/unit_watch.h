#ifndef PLACE_MEMORY_NODE_INPUT_UNIT_WATCH_H
#define PLACE_MEMORY_NODE_INPUT_UNIT_WATCH_H

#include <map>
#include <string>

#include "core/sensing/measurement.h"
#include "node/input/adapted_reading.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// Notices sensors whose driver does not speak in metres.
class UnitWatch {
 public:
  /// `reach`: how far from its middle a grid reaches along x and y [m].
  explicit UnitWatch(double reach) : reach_(reach) {}

  /// What is wrong with the units of the reading's sensor, by what it has said so far, in a
  /// sentence; empty: nothing.
  std::string note(const AdaptedReading& reading, const SensorRegistry& registry);

 private:
  struct Count {
    int beyond = 0;       // echoes that no grid holds
    bool within = false;  // one came that it does
  };

  double reach_;
  std::map<core::SensorId, Count> counts_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_UNIT_WATCH_H
