#include "node/input/range_adapter.h"

#include "node/base/ros_time.h"
#include "node/input/range_check.h"

namespace place_memory::node {

AdaptedReading RangeAdapter::adapt(const sensor_msgs::Range& message) const {
  AdaptedReading adapted;
  core::Measurement& measurement = adapted.measurement;
  measurement.stamp = toNanoseconds(message.header.stamp);
  measurement.frame = message.header.frame_id;
  measurement.sensor = registry_->idOf(topic_, measurement.frame);

  const core::SonarSpec spec{message.field_of_view, message.min_range, message.max_range};
  if (measurement.frame.empty()) {
    adapted.sensor_problem = "header.frame_id is empty";
  } else if (const auto problem = checkSpec(spec)) {
    adapted.sensor_problem = *problem;
  }
  if (!adapted.sensor_problem.empty()) {
    adapted.reject = Reject::kBadSensor;
  } else if (message.header.stamp.isZero()) {
    adapted.reject = Reject::kNoStamp;
  } else {
    const CheckedRange checked = checkRange(spec, message.range, over_range_is_no_echo_);
    adapted.reject = checked.reject;
    measurement.spec = checked.spec;
    measurement.range = checked.range;
  }
  return adapted;
}

}  // namespace place_memory::node
