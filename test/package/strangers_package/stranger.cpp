// Learns two rooms, and recognizes the first when it is scanned again; refuses a preset that is not
// there. Exits 1 where the library answers otherwise.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "place_memory/config/match_preset.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace {

namespace core = place_memory::core;

/// Readings from the middle of a rectangular room whose walls lie so far to the east, north, west
/// and south [m].
core::Scan scanRoom(double east, double north, double west, double south, int second) {
  core::Scan scan;
  for (int step = 0; step < 72; ++step) {
    const double yaw = core::kPi * step / 36.0;
    const double along_x = std::cos(yaw) > 0.0 ? east : west;
    const double along_y = std::sin(yaw) > 0.0 ? north : south;
    const double range = std::min(along_x / std::max(std::abs(std::cos(yaw)), 1e-6),
                                  along_y / std::max(std::abs(std::sin(yaw)), 1e-6));
    core::SonarReading reading;
    reading.sensor_pose = {0.0, 0.0, yaw};
    reading.spec = {0.26, 0.1, 10.0};
    reading.range = range;
    scan.readings.push_back(reading);
  }
  scan.grid =
      core::SonarModel(core::SonarModelOptions()).build(scan.readings, core::GridGeometry());
  scan.begin = std::chrono::seconds(second);
  scan.end = std::chrono::seconds(second + 1);
  return scan;
}

bool refusesMissingPreset() {
  try {
    place_memory::config::loadPreset("no_such_preset");
  } catch (const place_memory::config::ParameterError& error) {
    return !error.problems().empty();
  }
  return false;
}

bool refusesTakenLabel(core::PlaceMemory& memory) {
  try {
    memory.learn(scanRoom(3.0, 3.0, 3.0, 3.0, 300), "kitchen");
  } catch (const core::PlaceMemoryError& error) {
    return error.reason() == core::PlaceMemoryError::Reason::kLabelTaken;
  }
  return false;
}

bool works() {
  const auto preset = place_memory::config::loadPreset("evidence");
  core::PlaceMemoryOptions options;
  options.recognizer.metric = preset.metric;
  options.recognizer.rescoring = preset.rescoring;
  options.recognizer.calibration = preset.calibration;
  core::PlaceMemory memory(options);
  memory.learn(scanRoom(2.0, 1.5, 3.0, 2.5, 100), "kitchen");
  memory.learn(scanRoom(1.0, 4.0, 1.0, 4.0, 200), "hallway");
  const auto answer = memory.recognize(scanRoom(2.1, 1.5, 2.9, 2.5, 400), 0.5);
  return refusesMissingPreset() && refusesTakenLabel(memory) && memory.size() == 2 &&
         answer.labels.size() == 2 && answer.labels.front() == "kitchen" &&
         answer.recognition.matches.front().score > answer.recognition.matches.back().score;
}

}  // namespace

int main() {
  try {
    if (works()) return EXIT_SUCCESS;
    std::cerr << "the library answers otherwise\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
