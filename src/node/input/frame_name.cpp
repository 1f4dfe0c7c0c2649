#include "node/input/frame_name.h"

#include "support/text.h"

namespace place_memory::node {

std::optional<std::string> checkFrameName(const std::string& name) {
  if (name.size() > kMostFrameBytes) {
    return "has " + std::to_string(name.size()) + " bytes, of which it may have " +
           std::to_string(kMostFrameBytes);
  }
  if (support::hasControls(name)) return "holds line breaks or other control characters";
  return std::nullopt;
}

std::string frameName(const std::string& name, std::string& problem) {
  const auto wrong = checkFrameName(name);
  if (!wrong) return support::withoutLeadingSlashes(name);
  problem = "header.frame_id " + *wrong;
  return {};
}

}  // namespace place_memory::node
