#ifndef PLACE_MEMORY_NODE_INPUT_HEADING_ADAPTER_H
#define PLACE_MEMORY_NODE_INPUT_HEADING_ADAPTER_H

#include <sensor_msgs/Imu.h>
#include <sensor_msgs/MagneticField.h>
#include <std_msgs/Float64.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "node/input/heading_check.h"

namespace place_memory::node {

/// Takes the messages of a compass, and turns what they say as the parameters heading/ have it.
class HeadingAdapter {
 public:
  /// The parameters must outlive the adapter.
  explicit HeadingAdapter(const config::Parameters& parameters) : parameters_(&parameters) {}

  /// The orientation of an Imu that is mounted as tf says; where tf does not know its frame, as the
  /// robot's own.
  CheckedHeading adapt(const sensor_msgs::Imu& message, const tf2::BufferCore& transforms);

  /// The field points to magnetic north. A frame that tf does not know is taken for the robot's.
  CheckedHeading adapt(const sensor_msgs::MagneticField& message,
                       const tf2::BufferCore& transforms);

  /// A bearing in degrees, clockwise from north, of the time at which it came.
  CheckedHeading adapt(const std_msgs::Float64& message, std::chrono::nanoseconds received) const;

  /// That tf does not know the compass' frame, in a sentence, once that is sure; empty: it does.
  const std::string& frameProblem() const { return frame_problem_; }

 private:
  /// How `source` lies in `target`; nothing where one is the other, or tf does not know.
  std::optional<geometry_msgs::Quaternion> rotation(const tf2::BufferCore& transforms,
                                                    const std::string& target,
                                                    const std::string& source);
  /// `bearing`: of the robot, clockwise from magnetic north [rad].
  double yawOfBearing(double bearing) const;
  double corrected(double yaw) const;

  const config::Parameters* parameters_;
  int without_frame_ = 0;  // messages whose frame tf did not know, in a row
  std::string frame_problem_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_HEADING_ADAPTER_H
