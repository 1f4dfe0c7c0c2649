#ifndef PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H
#define PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H

#include <sensor_msgs/Range.h>

#include <optional>
#include <string>

#include "place_memory/core/sonar_reading.h"

namespace place_memory::node {

/// Why a reading is left out of a scan.
enum class Reject {
  kNan,            ///< range is NaN
  kTooClose,       ///< range is -inf: something nearer than min_range; no cell is touched
  kBelowMinRange,  ///< finite
  kAboveMaxRange,  ///< finite
  kFixedDistance,  ///< finite, from a sensor whose min_range is its max_range (REP 117)
  kBadSensor,      ///< the sensor's own limits make no sense
  kNoStamp,        ///< stamp is 0
  kOld,            ///< stamped before the scan began, and long before the message came
  kVertical,       ///< the sensor looks up or down
  kNoTransform,    ///< of the sensor at its stamp
  kNoOdometry,     ///< at its stamp
  kNoHeading,      ///< at its stamp
  kScanFull,       ///< the scan holds as many readings as it may
};
constexpr std::size_t kRejects = static_cast<std::size_t>(Reject::kScanFull) + 1;

/// In a few words for people, e.g. "no transform".
const char* toString(Reject reject);

/// What is wrong with a sensor's limits, in a sentence; nothing where they make sense.
std::optional<std::string> checkSensor(const sensor_msgs::Range& message);

/// A message without the pose of its sensor: either a usable range or the reason why it is none.
struct CheckedRange {
  std::optional<Reject> reject;
  core::SonarSpec spec;
  double range = 0.0;  ///< as SonarReading::range
};

/// REP 117. `over_range_is_no_echo`: a finite range beyond max_range is taken for no echo.
CheckedRange checkRange(const sensor_msgs::Range& message, bool over_range_is_no_echo);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H
