#ifndef PLACE_MEMORY_NODE_INPUT_ECHO_DIALECT_H
#define PLACE_MEMORY_NODE_INPUT_ECHO_DIALECT_H

#include <chrono>
#include <limits>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::node {

/// How the driver of one sensor says that no echo came, where it does not say +inf (REP 117).
/// It is told from the ranges in their order alone, whatever the pace at which they come.
class EchoDialect {
 public:
  /// Whether the sensor's next range is such a word; then what kind of value it is, as "max_range".
  /// max_range within a hair, or up to a hundredth more, FLT_MAX, -1 and 0 with min_range 0 count
  /// at once; another negative value once the sensor has repeated it; one beyond max_range
  /// likewise, but only where echoes came, too; a value at the top of what the sensor ever said
  /// once it came back several times, and nothing came near it. A range whose stamp is not newer
  /// than all before says nothing of the sensor: a bag may be read twice.
  std::optional<std::string> noEcho(std::chrono::nanoseconds stamp, double range,
                                    const core::SonarSpec& spec,
                                    const config::NoEchoOptions& options);
  /// The value outside the limits that the sensor says again and again, with no other one outside
  /// them meanwhile, of whatever noEcho() makes of it; nothing where there is none.
  std::optional<double> repeatedOutside() const;

 private:
  void follow(double range, const core::SonarSpec& spec);
  bool topRepeats(double range, const core::SonarSpec& spec) const;
  bool outsideRepeats(double range, int times) const;

  std::chrono::nanoseconds newest_ = std::chrono::nanoseconds::min();
  bool echoes_ = false;  // one came within the limits

  double outside_ = std::numeric_limits<double>::quiet_NaN();  // newest value outside the limits
  int outside_times_ = 0;

  double top_ = -std::numeric_limits<double>::infinity();   // the farthest within the limits
  double next_ = -std::numeric_limits<double>::infinity();  // the farthest but that one
  int top_runs_ = 0;  // times that it came, with another one between
  bool at_top_ = false;
};

/// Whether a range is max_range, but for the rounding of floats and a driver's last digit, or one
/// that a driver clamps to just beyond it.
bool isMaxRange(double range, double max_range);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_ECHO_DIALECT_H
