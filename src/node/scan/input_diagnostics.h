#ifndef PLACE_MEMORY_NODE_SCAN_INPUT_DIAGNOSTICS_H
#define PLACE_MEMORY_NODE_SCAN_INPUT_DIAGNOSTICS_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/input/transform_input.h"
#include "node/scan/compass_health.h"
#include "node/scan/sensor_health.h"

namespace place_memory::node {

/// How everything is that the node listens to, of the last ten seconds.
struct InputHealth {
  std::vector<SensorHealth> sensors;
  CompassHealth compass;
  std::vector<std::string> sonar_topics;  ///< as they are resolved
  std::string heading_topic;              ///< likewise; empty: there is no compass
  std::vector<std::string> wrong_types;   ///< sentences on topics whose type is none that is read
};

/// On which topics of sonars nothing was ever heard while there are others that speak, in a
/// sentence; empty: there is none.
std::string silentTopics(const InputHealth& health);

/// ERROR where a sensor's limits make no sense, WARN where there is no sensor, or none on one of
/// the topics, one is silent, has a wrong clock or unit, or has nearly all of its readings left
/// out; a value for each sensor.
void diagnoseSonars(const InputHealth& health, diagnostic_updater::DiagnosticStatusWrapper& status);

/// WARN where no heading comes or one is left out; the rate.
void diagnoseCompass(const InputHealth& health,
                     diagnostic_updater::DiagnosticStatusWrapper& status);

/// WARN where tf does not know the way from the robot to odometry or from a sensor that is heard to
/// the robot, where odometry is old at `now`, or where transforms were left out.
void diagnoseTransforms(const tf2::BufferCore& buffer, const TransformInput::LeftOut& left_out,
                        const InputHealth& health, const config::Parameters& parameters,
                        std::chrono::nanoseconds now,
                        diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_INPUT_DIAGNOSTICS_H
