#ifndef PLACE_MEMORY_CORE_RECOGNIZE_SENSOR_DOCTOR_H
#define PLACE_MEMORY_CORE_RECOGNIZE_SENSOR_DOCTOR_H

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

enum class SensorFault {
  kNone,
  kDead,        ///< nothing comes of it any more
  kNeverHears,  ///< readings come, but none has an echo where the grids have walls
  kBlocked,     ///< always short, and the same distance, where the grids are empty
  kCrosstalk,   ///< short again and again, by what another sensor hears
  kMountedOff,  ///< what it hears fits the grids where its axis is turned
};

struct SensorDiagnosis {
  std::uint32_t sensor = 0;
  SensorFault fault = SensorFault::kNone;
  std::uint32_t other = 0;   ///< with kCrosstalk: the sensor that it hears
  double range = 0.0;        ///< with kBlocked: at which [m]
  double yaw_error = 0.0;    ///< to be added to the yaw of its mount, as estimated [rad]
  double uncertainty = 0.0;  ///< 1 sigma of that [rad]; 0: there is no estimate
  std::size_t readings = 0;  ///< that were looked at
};

/// Tells by learned grids which of a robot's sensors is at fault.
///
/// It is shown scans that were recognized, each with the grid of its place, and keeps the newest
/// thirty. A grid in which the same fault was learned from the same heading hides it.
class SensorDoctor {
 public:
  explicit SensorDoctor(const SonarModelOptions& options) : model_(options) {}

  /// The scan must tell its sensors apart; `place_from_scan` lays it into the grid.
  void examine(const Scan& scan, const EvidenceGrid& place, const Pose2d& place_from_scan);
  void clear() { scans_.clear(); }

  std::size_t scans() const { return scans_.size(); }
  /// One for each sensor that was ever heard in those scans, by rising number. Nothing is said of a
  /// sensor before three scans and ten readings.
  std::vector<SensorDiagnosis> diagnose() const;

 private:
  static constexpr int kOffsets = 21;  // of the axis that are tried
  static constexpr std::size_t kMostScans = 30;

  struct Findings {  // of one sensor in one scan
    std::size_t readings = 0;
    std::size_t echoes = 0;
    std::size_t due = 0;                        // echoes that the grid promises
    std::vector<double> ranges;                 // of its echoes [m]
    std::vector<double> shorts;                 // ranges where the grid is empty [m]
    std::map<std::uint32_t, std::size_t> like;  // how many of those another sensor heard too
    std::vector<double> fit;  // with the axis turned, by offset; empty: too few readings
  };
  using Sensors = std::map<std::uint32_t, Findings>;

  struct Turned {  // of an axis
    double by = 0.0;
    double uncertainty = 0.0;  ///< 1 sigma of that [rad]; 0: there is no estimate
    bool is_sure = false;
  };

  std::vector<double> fitTurned(const std::vector<SonarReading>& readings,
                                const EvidenceGrid& place) const;
  SensorDiagnosis diagnose(std::uint32_t sensor) const;
  bool isDead(std::uint32_t sensor) const;
  Turned turnOf(std::uint32_t sensor) const;

  SonarModel model_;
  std::deque<Sensors> scans_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_SENSOR_DOCTOR_H
