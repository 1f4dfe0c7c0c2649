#include "node/input/transform_input.h"

#include <exception>
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
    // Not yet read, so that its lengths are looked at first.
    const boost::function<void(const RawMessage::ConstPtr&)> on_message =
        [this, is_static](const RawMessage::ConstPtr& message) { take(*message, is_static); };
    subscribers_.push_back(names_.subscribe<RawMessage>(topic, kQueueLength, on_message));
  };
  subscribe("/tf", false);
  subscribe("/tf_static", true);
  spinner_.start();
}

TransformInput::~TransformInput() {
  spinner_.stop();
  subscribers_.clear();
}

void TransformInput::take(const RawMessage& message, bool is_static) {
  try {
    const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
    if (transforms) return add(*transforms, is_static);
    leaveOut("a message on /tf or /tf_static was left out: it is " + message.getDataType() +
             ", not tf2_msgs/TFMessage as it is known here");
  } catch (const std::exception& error) {  // cut short, or its sizes are lies
    leaveOut(std::string("a message on /tf or /tf_static was left out: ") + error.what());
  }
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
    if (problem) leaveOut(*problem);
  }
}

void TransformInput::leaveOut(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  count_.add(steadyNow());
  newest_ = problem_ = problem;
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
