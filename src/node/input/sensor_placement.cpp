#include "node/input/sensor_placement.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <exception>
#include <vector>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"

namespace place_memory::node {

std::string knownFrames(const tf2::BufferCore& buffer) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> frames;
  buffer._getFrameStrings(frames);
  if (frames.empty()) return "it knows none yet: is anything published on /tf?";
  std::sort(frames.begin(), frames.end());
  const std::size_t more = frames.size() > kMost ? frames.size() - kMost : 0;
  frames.resize(frames.size() - more);
  return "it knows " + boost::algorithm::join(frames, ", ") +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

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
  std::string unknown;
  for (const std::string& frame : {source, target}) {
    if (!buffer._frameExists(frame)) unknown = frame;
  }
  if (!unknown.empty()) problem = "tf knows no frame " + unknown + "; " + knownFrames(buffer);
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
