#include "node/input/transform_input.h"

#include <utility>

#include "node/base/ros_time.h"
#include "node/input/transform_filter.h"

namespace place_memory::node {
namespace {

constexpr std::uint32_t kQueueLength = 100;

}  // namespace

TransformInput::TransformInput(const ros::NodeHandle& names, tf2::BufferCore& buffer,
                               Listener listener)
    : buffer_(buffer), listener_(std::move(listener)), names_(names) {
  names_.setCallbackQueue(&queue_);
  const auto subscribe = [this](const char* topic, bool is_static) {
    const boost::function<void(const tf2_msgs::TFMessage::ConstPtr&)> take =
        [this, is_static](const tf2_msgs::TFMessage::ConstPtr& message) {
          add(*message, is_static);
        };
    subscribers_.push_back(names_.subscribe<tf2_msgs::TFMessage>(topic, kQueueLength, take));
  };
  subscribe("/tf", false);
  subscribe("/tf_static", true);
  spinner_.start();
}

TransformInput::~TransformInput() {
  spinner_.stop();
  subscribers_.clear();
}

void TransformInput::add(const tf2_msgs::TFMessage& message, bool is_static) {
  if (listener_) {
    for (const auto& transform : message.transforms) listener_(transform, is_static);
  }
  const std::chrono::nanoseconds now = rosNow();
  // Before simulated time runs nobody can say which stamps may be.
  if (now.count() == 0 && !is_static) return;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const auto problem = addTransform(transform, is_static, now, buffer_);
    if (!problem) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    count_.add(steadyNow());
    newest_ = problem_ = *problem;
  }
}

TransformInput::LeftOut TransformInput::leftOut() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {count_.at(steadyNow()), newest_};
}

std::string TransformInput::takeProblem() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(problem_, {});
}

}  // namespace place_memory::node
