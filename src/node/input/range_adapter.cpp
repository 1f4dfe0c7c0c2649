#include "node/input/range_adapter.h"

#include <limits>

#include "node/base/ros_time.h"
#include "node/input/frame_name.h"
#include "node/input/range_check.h"

namespace place_memory::node {

AdaptedReading RangeAdapter::adapt(const sensor_msgs::Range& message) {
  AdaptedReading adapted;
  core::Measurement& measurement = adapted.measurement;
  measurement.stamp = toNanoseconds(message.header.stamp);
  measurement.frame = frameName(message.header.frame_id, adapted.sensor_problem);
  measurement.sensor = registry_->idOf(topic_, measurement.frame);

  const core::SonarSpec spec{message.field_of_view, message.min_range, message.max_range};
  if (adapted.sensor_problem.empty()) {
    adapted.sensor_problem =
        measurement.frame.empty() ? "header.frame_id is empty" : checkSpec(spec).value_or("");
  }
  if (!adapted.sensor_problem.empty()) {
    adapted.reject = Reject::kBadSensor;
  } else if (message.header.stamp.isZero()) {
    adapted.reject = Reject::kNoStamp;
  } else {
    double range = message.range;
    EchoDialect& dialect = dialects_[measurement.sensor];
    const auto no_echo = dialect.noEcho(measurement.stamp, range, spec, parameters_->no_echo);
    if (no_echo) {
      adapted.no_echo = NoEchoWord{range, *no_echo};
      range = std::numeric_limits<double>::infinity();
    }
    const CheckedRange checked = checkRange(spec, range, parameters_->scan);
    adapted.reject = checked.reject;
    if (checked.reject && dialect.repeatedOutside() == range) adapted.repeated = range;
    measurement.spec = checked.reject ? spec : checked.spec;
    measurement.range = checked.range;
  }
  return adapted;
}

}  // namespace place_memory::node
