#ifndef PLACE_MEMORY_NODE_INPUT_SENSOR_PLACEMENT_H
#define PLACE_MEMORY_NODE_INPUT_SENSOR_PLACEMENT_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <optional>
#include <string>

#include "node/input/planar.h"

namespace place_memory::node {

/// Pose of the frame `source` in the frame `target` as seen from above. Never waits. Where tf does
/// not know it, nothing, and `problem` names both frames and says why.
std::optional<PlanarPose> lookupPlanar(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, std::chrono::nanoseconds stamp,
                                       std::string& problem);

/// The frames that tf knows, in a sentence, as "it knows base_link, odom".
std::string knownFrames(const tf2::BufferCore& buffer);

/// The newest there is, and its stamp; nothing where tf knows none.
std::optional<PlanarPose> lookupNewest(const tf2::BufferCore& buffer, const std::string& target,
                                       const std::string& source, std::chrono::nanoseconds& stamp);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_SENSOR_PLACEMENT_H
