#ifndef PLACE_MEMORY_NODE_INPUT_FRAME_NAME_H
#define PLACE_MEMORY_NODE_INPUT_FRAME_NAME_H

#include <optional>
#include <string>

namespace place_memory::node {

/// Longer than any that a person gives [bytes]. Names are kept for as long as the node runs, and go
/// into its log.
constexpr std::size_t kMostFrameBytes = 256;

/// What is wrong with the name of a frame in a message, in words that go on from the name of its
/// field; nothing, also where it is empty.
std::optional<std::string> checkFrameName(const std::string& name);

/// A frame as tf2 has it, without leading slashes. Empty where it is no name, and `problem` then
/// says why.
std::string frameName(const std::string& name, std::string& problem);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_FRAME_NAME_H
