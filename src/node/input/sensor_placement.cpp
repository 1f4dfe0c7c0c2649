#include "node/input/sensor_placement.h"

#include <exception>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"

namespace place_memory::node {

std::optional<PlanarPose> lookupPlanar(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, std::chrono::nanoseconds stamp,
                                       std::string& problem) {
  try {
    const PlanarPose found =
        planar(buffer.lookupTransform(target, source, toRosTime(stamp)).transform);
    if (found.pose.isFinite()) return found;
    problem = "it is not finite";
  } catch (const std::exception& error) {  // tf2's own, and those of ros::Time
    problem = error.what();
  }
  problem = "no transform from " + source + " to " + target + ": " + problem;
  return std::nullopt;
}

std::optional<PlanarPose> lookupNewest(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, std::chrono::nanoseconds& stamp) {
  try {
    const auto found = buffer.lookupTransform(target, source, ros::Time(0));
    stamp = toNanoseconds(found.header.stamp);
    const PlanarPose pose = planar(found.transform);
    if (pose.pose.isFinite()) return pose;
  } catch (const std::exception&) {  // likewise
  }
  return std::nullopt;
}

}  // namespace place_memory::node
