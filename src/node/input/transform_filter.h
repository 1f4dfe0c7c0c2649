#ifndef PLACE_MEMORY_NODE_INPUT_TRANSFORM_FILTER_H
#define PLACE_MEMORY_NODE_INPUT_TRANSFORM_FILTER_H

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace place_memory::node {

/// A transform stamped further ahead of the clock would hide all that come until then.
constexpr std::chrono::nanoseconds kMaxAhead = std::chrono::seconds(1);

/// Nothing of a robot is further from the origin of a frame that it uses, along an axis [m]; ten
/// times as far as coordinates of UTM reach.
constexpr double kFarthest = 1e8;

/// So that messages with ever new frames take no memory.
constexpr std::size_t kMostFrames = 4096;

/// Why a transform must not be believed, in a sentence without its frames; nothing where it may.
/// `now`: when it came. The stamp of a static one means nothing.
std::optional<std::string> checkTransform(const geometry_msgs::TransformStamped& transform,
                                          bool is_static, std::chrono::nanoseconds now);

/// Puts the transform into the buffer if it may be believed, its frames without leading slashes,
/// which tf2 does not know. Otherwise returns what is wrong with
/// it, with both its frames.
std::optional<std::string> addTransform(const geometry_msgs::TransformStamped& transform,
                                        bool is_static, std::chrono::nanoseconds now,
                                        tf2::BufferCore& buffer);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_TRANSFORM_FILTER_H
