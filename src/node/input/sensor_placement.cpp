#include "node/input/sensor_placement.h"

#include <tf2/exceptions.h>

namespace place_memory::node {

std::optional<PlanarPose> lookupPlanar(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, const ros::Time& stamp,
                                       std::string& problem) {
  try {
    const PlanarPose found = planar(buffer.lookupTransform(target, source, stamp).transform);
    if (found.pose.isFinite()) return found;
    problem = "it is not finite";
  } catch (const tf2::TransformException& error) {
    problem = error.what();
  }
  problem = "no transform from " + source + " to " + target + ": " + problem;
  return std::nullopt;
}

std::optional<PlanarPose> lookupNewest(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, ros::Time& stamp) {
  try {
    const auto found = buffer.lookupTransform(target, source, ros::Time(0));
    stamp = found.header.stamp;
    return planar(found.transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace place_memory::node
