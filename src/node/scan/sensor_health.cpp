#include "node/scan/sensor_health.h"

#include <algorithm>

namespace place_memory::node {

void SensorHealthTable::noteMessage(const AdaptedReading& reading, std::chrono::nanoseconds now) {
  const auto [known, is_new] = sensors_.try_emplace(reading.measurement.sensor);
  Sensor& sensor = known->second;
  if (is_new) sensor.first = now;
  sensor.newest = now;
  sensor.messages.add(now);
  sensor.problem = reading.sensor_problem;
  if (!reading.reject) sensor.unit_problem = reading.unit_problem;
}

void SensorHealthTable::noteReject(core::SensorId sensor, Reject reject,
                                   std::chrono::nanoseconds now) {
  sensors_[sensor].rejected.at(static_cast<std::size_t>(reject)).add(now);
}

std::set<core::SensorId> SensorHealthTable::heardWithin(std::chrono::nanoseconds time,
                                                        std::chrono::nanoseconds now) const {
  std::set<core::SensorId> heard;
  for (const auto& [id, sensor] : sensors_) {
    if (id != kOtherSensors && now - sensor.newest < time) heard.insert(id);
  }
  return heard;
}

bool SensorHealthTable::isReplaced(core::SensorId sensor, const SensorRegistry& registry,
                                   std::chrono::nanoseconds now) const {
  const std::chrono::nanoseconds newest = sensors_.at(sensor).newest;
  if (now - newest <= kSensorSilence) return false;
  return std::any_of(sensors_.begin(), sensors_.end(), [&](const auto& other) {
    return other.second.first > newest && registry.topicOf(other.first) == registry.topicOf(sensor);
  });
}

std::vector<SensorHealth> SensorHealthTable::report(const SensorRegistry& registry,
                                                    std::chrono::nanoseconds now) const {
  std::vector<SensorHealth> report;
  for (const auto& [id, sensor] : sensors_) {
    if (isReplaced(id, registry, now)) continue;
    SensorHealth& health = report.emplace_back();
    health.id = id;
    health.name = registry.nameOf(id);
    health.topic = registry.topicOf(id);
    if (id != kOtherSensors) health.frame = registry.frameOf(id);
    health.is_of_ring = registry.isOfRing(id);
    health.messages = sensor.messages.at(now);
    std::transform(sensor.rejected.begin(), sensor.rejected.end(), health.rejected.begin(),
                   [&](const core::RecentCount& count) { return count.at(now); });
    health.silent = now - sensor.newest;
    health.sensor_problem = sensor.problem;
    health.unit_problem = sensor.unit_problem;
  }
  return report;
}

}  // namespace place_memory::node
