#ifndef PLACE_MEMORY_NODE_INPUT_ADAPTED_READING_H
#define PLACE_MEMORY_NODE_INPUT_ADAPTED_READING_H

#include <optional>
#include <string>

#include "core/sensing/measurement.h"
#include "node/input/reject.h"

namespace place_memory::node {

/// A range that was taken for no echo, though it is not +inf.
struct NoEchoWord {
  double range = 0.0;  ///< [m]
  std::string kind;    ///< what value that is, as "its max_range"
};

/// What an adapter makes of a sensor's message, usable or not.
struct AdaptedReading {
  core::Measurement measurement;  ///< stamp, frame and sensor are always those of the message
  std::optional<Reject> reject;   ///< why it cannot be used
  std::string sensor_problem;     ///< with Reject::kBadSensor, in a sentence
  std::string unit_problem;       ///< the sensor does not seem to speak in metres, in a sentence
  std::optional<NoEchoWord> no_echo;
  /// With a range outside the limits: it is the one that the sensor says again and again [m].
  std::optional<double> repeated;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_ADAPTED_READING_H
