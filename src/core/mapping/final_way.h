#ifndef PLACE_MEMORY_CORE_MAPPING_FINAL_WAY_H
#define PLACE_MEMORY_CORE_MAPPING_FINAL_WAY_H

#include <chrono>
#include <vector>

#include "core/map/kept_map.h"

namespace place_memory::core {

/// Where the robot was on its way, as the map lies now: odometry from scan to scan, spread over
/// what both say.
class FinalWay {
 public:
  /// Of the nodes from `first` on that lie in the map's frame, that of session 1; by rising stamp.
  explicit FinalWay(const std::vector<ScanNode>& nodes, NodeIndex first = 0);

  bool empty() const { return scans_.empty(); }
  /// Of the base in the map, where odometry had it there then. Of an empty way, what odometry says.
  Pose2d at(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base) const;

 private:
  struct Scan {
    std::chrono::nanoseconds stamp;
    Pose2d map_from_odom;
  };

  std::vector<Scan> scans_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_FINAL_WAY_H
