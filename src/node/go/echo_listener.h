#ifndef PLACE_MEMORY_NODE_GO_ECHO_LISTENER_H
#define PLACE_MEMORY_NODE_GO_ECHO_LISTENER_H

#include <tf2/buffer_core.h>

#include <atomic>
#include <mutex>
#include <string>

#include "core/drive/echo_ring.h"
#include "node/input/message_intake.h"

namespace place_memory::node {

/// What the sonars hear about the robot while it is driven. Thread-safe.
class EchoListener {
 public:
  /// Both must outlive it.
  EchoListener(const tf2::BufferCore& buffer, const std::string& base_frame)
      : buffer_(buffer), base_frame_(base_frame) {}

  /// What a message said; left out while nobody listens.
  void take(const Taken& taken);

  /// Somebody listens from now on, or listens no more.
  void begin() { ++listeners_; }
  void end() { --listeners_; }

  core::EchoRing ring() const;

 private:
  const tf2::BufferCore& buffer_;
  const std::string base_frame_;
  std::atomic<int> listeners_{0};
  mutable std::mutex mutex_;
  core::EchoRing ring_{std::chrono::seconds(1)};
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_ECHO_LISTENER_H
