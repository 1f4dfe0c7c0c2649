#ifndef PLACE_MEMORY_NODE_INPUT_TRANSFORM_INPUT_H
#define PLACE_MEMORY_NODE_INPUT_TRANSFORM_INPUT_H

#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/sensing/recent_count.h"
#include "node/base/guarded_queue.h"

namespace place_memory::node {

/// Listens to tf on a thread of its own, and keeps what may not be believed out of the buffer:
/// tf2's own listener throws on some stamps, and forgets everything where time goes back a little.
class TransformInput {
 public:
  /// Is told of every transform, on the input's thread; where it is a static one, so it says.
  using Listener = std::function<void(const geometry_msgs::TransformStamped&, bool is_static)>;

  /// The buffer must outlive it. `listener` may be null.
  TransformInput(const ros::NodeHandle& names, tf2::BufferCore& buffer,
                 Listener listener = nullptr);
  ~TransformInput();
  TransformInput(const TransformInput&) = delete;
  TransformInput& operator=(const TransformInput&) = delete;

  /// What was left out within the last ten seconds. Thread-safe, as takeProblem().
  struct LeftOut {
    std::uint32_t transforms = 0;
    std::string newest;  ///< in a sentence with its frames
  };
  LeftOut leftOut() const;

  /// Why a transform was left out since the last call, in a sentence; empty: none was.
  std::string takeProblem();

 private:
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  tf2::BufferCore& buffer_;
  const Listener listener_;

  mutable std::mutex mutex_;  // guards the next three
  core::RecentCount count_;   // by a clock that nobody sets
  std::string newest_;
  std::string problem_;

  GuardedQueue queue_{"transforms"};
  ros::NodeHandle names_;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_TRANSFORM_INPUT_H
