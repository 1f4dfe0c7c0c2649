#include "core/mapping/final_way.h"

#include <algorithm>

namespace place_memory::core {

FinalWay::FinalWay(const std::vector<ScanNode>& nodes, NodeIndex first) {
  for (NodeIndex at = first; at < nodes.size(); ++at) {
    const ScanNode& node = nodes[at];
    if (node.session != 1) continue;
    scans_.push_back({node.stamp, node.pose * node.odom_from_base.inverse()});
  }
}

Pose2d FinalWay::at(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base) const {
  if (scans_.empty()) return odom_from_base;
  const auto after = std::lower_bound(
      scans_.begin(), scans_.end(), stamp,
      [](const Scan& scan, std::chrono::nanoseconds wanted) { return scan.stamp < wanted; });
  if (after == scans_.begin()) return after->map_from_odom * odom_from_base;
  const auto before = after - 1;
  const Pose2d a = before->map_from_odom * odom_from_base;
  if (after == scans_.end()) return a;
  const Pose2d b = after->map_from_odom * odom_from_base;
  const double share = std::chrono::duration<double>(stamp - before->stamp) /
                       std::chrono::duration<double>(after->stamp - before->stamp);
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          wrapAngle(a.yaw + share * wrapAngle(b.yaw - a.yaw))};
}

}  // namespace place_memory::core
