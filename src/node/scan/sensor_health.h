#ifndef PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H
#define PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/sensing/measurement.h"
#include "core/sensing/recent_count.h"
#include "node/input/adapted_reading.h"
#include "node/input/sensor_registry.h"

namespace place_memory::node {

/// A sensor that has sent nothing for so long is silent.
constexpr std::chrono::nanoseconds kSensorSilence = std::chrono::seconds(5);

/// How one sensor is.
struct SensorHealth {
  core::SensorId id = 0;
  std::string name;  ///< for people
  std::string topic;
  std::string frame;                   ///< empty: unknown
  bool is_of_ring = false;             ///< the frame is not its own, but that of a ring
  std::uint32_t messages = 0;          ///< within the last ten seconds
  RejectCounts rejected{};             ///< likewise
  std::chrono::nanoseconds silent{0};  ///< since its newest message
  std::string sensor_problem;          ///< what is wrong with its limits; empty: nothing
  std::string unit_problem;            ///< it does not seem to speak in metres; empty: it does
};

/// What comes of the sensors' messages. `now` is a time that never goes back.
class SensorHealthTable {
 public:
  void noteMessage(const AdaptedReading& reading, std::chrono::nanoseconds now);
  void noteReject(core::SensorId sensor, Reject reject, std::chrono::nanoseconds now);

  /// The sensors with a name that were heard so short a time ago.
  std::set<core::SensorId> heardWithin(std::chrono::nanoseconds time,
                                       std::chrono::nanoseconds now) const;
  /// Every sensor but those that fell silent when another one spoke up on their topic for the first
  /// time: their frame was corrected.
  std::vector<SensorHealth> report(const SensorRegistry& registry,
                                   std::chrono::nanoseconds now) const;

 private:
  struct Sensor {
    std::chrono::nanoseconds first{0};
    std::chrono::nanoseconds newest{0};
    core::RecentCount messages;
    std::array<core::RecentCount, kRejects> rejected{};
    std::string problem;
    std::string unit_problem;
  };

  bool isReplaced(core::SensorId sensor, const SensorRegistry& registry,
                  std::chrono::nanoseconds now) const;

  std::map<core::SensorId, Sensor> sensors_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SENSOR_HEALTH_H
