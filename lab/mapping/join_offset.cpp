#include "mapping/join_offset.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace place_memory::mapping {
namespace {

using core::Pose2d;

constexpr double kNear = 3.0;  // places about by which a join is judged [m]

}  // namespace

double joinOffset(const core::Mapper& mapper, const MappingRun& later, const Truth& truth) {
  const std::chrono::nanoseconds begin = later.moments.front().stamp;
  std::vector<core::MappedPlace> old;
  for (const core::MappedPlace& place : mapper.places()) {
    if (!place.apart && place.stamp < begin) old.push_back(place);
  }
  std::vector<double> offsets;
  for (const core::ScanNode& node : mapper.graph().nodes()) {
    if (node.session != 1 || node.stamp < begin) continue;
    for (const core::MappedPlace& place : old) {
      const Pose2d is = truth.at(place.stamp)->inverse() * *truth.at(node.stamp);
      const Pose2d got = place.map_from_base.inverse() * node.pose;
      if (std::hypot(is.x, is.y) > kNear) continue;
      offsets.push_back(std::hypot(is.x - got.x, is.y - got.y));
    }
  }
  if (offsets.empty()) return -1.0;
  std::nth_element(offsets.begin(), offsets.begin() + offsets.size() / 2, offsets.end());
  return offsets[offsets.size() / 2];
}

}  // namespace place_memory::mapping
