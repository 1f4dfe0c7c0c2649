#ifndef PLACE_MEMORY_NODE_SCAN_SONAR_DIAGNOSTICS_H
#define PLACE_MEMORY_NODE_SCAN_SONAR_DIAGNOSTICS_H

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/time.h>

#include <map>
#include <string>

#include "node/scan/sensor_health.h"

namespace place_memory::node {

/// A sensor that has sent nothing for so long is reported as silent.
const ros::Duration kSensorSilence(5.0);

/// ERROR where a sensor's limits make no sense, WARN where there is no sensor, one is silent, or
/// one has had every reading rejected; a value for each sensor.
void diagnoseSonars(const std::map<std::string, SensorHealth>& sensors, const ros::Time& now,
                    diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SONAR_DIAGNOSTICS_H
