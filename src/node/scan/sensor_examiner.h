#ifndef PLACE_MEMORY_NODE_SCAN_SENSOR_EXAMINER_H
#define PLACE_MEMORY_NODE_SCAN_SENSOR_EXAMINER_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/recognize/sensor_doctor.h"
#include "node/scan/sensor_health.h"
#include "place_memory/core/place_id.h"

namespace place_memory::node {

/// Shows recognized scans to the sensor doctor, and tells the diagnostics what it finds.
class SensorExaminer {
 public:
  /// Of a place, as it is learned; may throw.
  using GridOf = std::function<core::EvidenceGrid(core::PlaceId)>;

  SensorExaminer(const core::SonarModelOptions& options, GridOf grid_of)
      : doctor_(options), grid_of_(std::move(grid_of)) {}

  /// The scan was recognized. It is kept until it is examined, which takes a while. Thread-safe.
  void add(const core::Scan& scan, core::PlaceId place, const core::Pose2d& place_from_scan);

  /// Examines what was added, and writes what is known of each sensor. `sensors` as they are now;
  /// `buffer` knows how they are mounted on `base_frame`. By one thread only.
  void diagnose(const std::vector<SensorHealth>& sensors, const tf2::BufferCore& buffer,
                const std::string& base_frame, diagnostic_updater::DiagnosticStatusWrapper& status);

 private:
  struct Waiting {
    core::Scan scan;
    core::PlaceId place;
    core::Pose2d place_from_scan;
  };

  void examineWaiting();

  core::SensorDoctor doctor_;
  GridOf grid_of_;
  std::vector<core::SensorDiagnosis> diagnoses_;
  std::mutex mutex_;
  std::deque<Waiting> waiting_;
};

/// One diagnosis in a sentence that says what to do; empty where the sensor is well. `sensor` and
/// `other` are names for people.
std::string inWords(const core::SensorDiagnosis& diagnosis, const std::string& sensor,
                    const std::string& other);

/// The command with which a sensor's frame is published turned by `yaw_error` [rad]; empty where tf
/// does not know the frame.
std::string mendedMount(const tf2::BufferCore& buffer, const std::string& base_frame,
                        const std::string& frame, double yaw_error);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SENSOR_EXAMINER_H
