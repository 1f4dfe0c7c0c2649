#ifndef PLACE_MEMORY_NODE_SCAN_NEWEST_STAMPS_H
#define PLACE_MEMORY_NODE_SCAN_NEWEST_STAMPS_H

#include <chrono>
#include <map>
#include <string>

#include "core/sensing/heading_history.h"

namespace place_memory::node {

/// The newest stamp of each sensor, by frame_id: one whose clock is behind that of the others is no
/// sign that time was set back. Frames beyond kMaxFrames are not followed, so that messages with
/// ever new frames take no memory.
class NewestStamps {
 public:
  static constexpr std::size_t kMaxFrames = 256;

  /// How the stamp follows the newest one of its frame.
  core::TimeOrder note(const std::string& frame, std::chrono::nanoseconds stamp);
  void clear() { newest_.clear(); }

 private:
  std::map<std::string, std::chrono::nanoseconds> newest_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_NEWEST_STAMPS_H
