#include "node/input/transform_filter.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "node/base/ros_time.h"
#include "node/input/frame_name.h"
#include "support/text.h"

namespace place_memory::node {
namespace {

constexpr double kLeastNorm = 0.1;  // of a quaternion that was meant to be one

// tf2 keeps each frame for as long as it lives.
std::optional<std::string> checkRoom(const geometry_msgs::TransformStamped& transform,
                                     const tf2::BufferCore& buffer) {
  if (buffer._frameExists(transform.child_frame_id) &&
      buffer._frameExists(transform.header.frame_id)) {
    return std::nullopt;
  }
  std::vector<std::string> frames;
  buffer._getFrameStrings(frames);
  if (frames.size() < kMostFrames) return std::nullopt;
  return "there are " + std::to_string(frames.size()) + " frames already, more than any robot has";
}

std::string shown(const std::string& frame) {
  return support::printable(frame.substr(0, kMostFrameBytes));
}

}  // namespace

std::optional<std::string> checkTransform(const geometry_msgs::TransformStamped& transform,
                                          bool is_static, std::chrono::nanoseconds now) {
  for (const std::string& frame : {transform.header.frame_id, transform.child_frame_id}) {
    if (const auto wrong = checkFrameName(frame)) return "the name of a frame " + *wrong;
  }
  const geometry_msgs::Quaternion& q = transform.transform.rotation;
  const geometry_msgs::Vector3& t = transform.transform.translation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!std::isfinite(norm)) return "its rotation is not finite";
  if (norm < kLeastNorm) return "its rotation is a quaternion of zeros";
  if (!std::isfinite(t.x + t.y + t.z)) return "its translation is not finite";
  if (std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)}) > kFarthest) {
    return "its translation leads further than anything lies: is it in metres?";
  }
  if (is_static) return std::nullopt;
  if (transform.header.stamp.isZero()) return "its stamp is 0";
  const auto ahead = toNanoseconds(transform.header.stamp) - now;
  if (ahead > kMaxAhead) {
    return "it is stamped " + inSeconds(ahead) +
           " ahead of the clock: is the clock right where it is published?";
  }
  return std::nullopt;
}

std::optional<std::string> addTransform(const geometry_msgs::TransformStamped& slashed,
                                        bool is_static, std::chrono::nanoseconds now,
                                        tf2::BufferCore& buffer) {
  geometry_msgs::TransformStamped transform = slashed;
  transform.header.frame_id = support::withoutLeadingSlashes(slashed.header.frame_id);
  transform.child_frame_id = support::withoutLeadingSlashes(slashed.child_frame_id);
  std::optional<std::string> problem = checkTransform(transform, is_static, now);
  try {
    if (!problem) problem = checkRoom(transform, buffer);
    // What it refuses by itself, such as a transform that is older than its memory, it says itself.
    if (!problem) buffer.setTransform(transform, "tf", is_static);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem) return std::nullopt;
  return "transform from " + shown(transform.child_frame_id) + " to " +
         shown(transform.header.frame_id) + " left out: " + *problem;
}

}  // namespace place_memory::node
