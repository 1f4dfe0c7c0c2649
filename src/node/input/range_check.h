#ifndef PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H
#define PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H

#include <optional>
#include <string>

#include "config/parameters.h"
#include "node/input/reject.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::node {

/// What is wrong with a sensor's limits, in a sentence; nothing where they make sense.
std::optional<std::string> checkSpec(const core::SonarSpec& spec);

/// One distance of a sensor: either usable or the reason why it is not.
struct CheckedRange {
  std::optional<Reject> reject;
  core::SonarSpec spec;
  double range = 0.0;  ///< as SonarReading::range
};

/// REP 117, for a sensor whose limits make sense; but what `scan` says is no echo is taken for it.
CheckedRange checkRange(const core::SonarSpec& spec, double range, const config::ScanOptions& scan);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_RANGE_CHECK_H
