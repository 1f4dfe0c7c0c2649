#include "node/scan/sonar_diagnostics.h"

#include <numeric>

namespace place_memory::node {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

void summarize(const std::string& frame, const SensorHealth& sensor, const ros::Time& now,
               diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!sensor.sensor_problem.empty()) {
    status.mergeSummary(Level::ERROR, frame + ": " + sensor.sensor_problem);
    return;
  }
  const auto rejected =
      std::accumulate(sensor.rejected.begin(), sensor.rejected.end(), std::uint64_t{0});
  if (now - sensor.last_received > kSensorSilence) {
    status.mergeSummary(Level::WARN, frame + ": silent");
  } else if (rejected >= sensor.messages) {
    status.mergeSummary(Level::WARN, frame + ": every reading is rejected");
  }
}

}  // namespace

void diagnoseSonars(const std::map<std::string, SensorHealth>& sensors, const ros::Time& now,
                    diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.summary(Level::OK, std::to_string(sensors.size()) + " sensors");
  if (sensors.empty()) status.summary(Level::WARN, "no sensor has sent a reading");
  for (const auto& [frame, sensor] : sensors) {
    summarize(frame, sensor, now, status);
    const std::string rejected = inWords(sensor.rejected);
    status.add(frame, std::to_string(sensor.messages) + " messages" +
                          (rejected.empty() ? "" : ", " + rejected));
  }
}

}  // namespace place_memory::node
