#include "node/input/range_check.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "place_memory/core/pose2d.h"

namespace place_memory::node {
namespace {

// Messages carry floats: pi as a float is above pi.
constexpr double kWidest = core::kPi * (1.0 + 1e-6);

constexpr std::array<const char*, kRejects> kWords = {
    "range is NaN", "too close",  "below min_range", "above max_range",  "fixed distance",
    "bad sensor",   "no stamp",   "old stamp",       "looks up or down", "no transform",
    "no odometry",  "no heading", "scan is full",
};

CheckedRange rejected(Reject reject) {
  CheckedRange checked;
  checked.reject = reject;
  return checked;
}

}  // namespace

const char* toString(Reject reject) { return kWords.at(static_cast<std::size_t>(reject)); }

std::optional<std::string> checkSensor(const sensor_msgs::Range& message) {
  const double fov = message.field_of_view;
  const double min = message.min_range;
  const double max = message.max_range;
  std::ostringstream problem;
  if (message.header.frame_id.empty()) {
    problem << "header.frame_id is empty";
  } else if (!(fov > 0.0 && fov <= kWidest)) {
    problem << "field_of_view must be in (0, pi] rad, not " << fov;
  } else if (!(min >= 0.0 && std::isfinite(min))) {
    problem << "min_range must be finite and not negative, not " << min << " m";
  } else if (!(max > 0.0 && std::isfinite(max))) {
    problem << "max_range must be finite and positive, not " << max << " m";
  } else if (min > max) {
    problem << "min_range must not exceed max_range, but " << min << " m > " << max << " m";
  } else {
    return std::nullopt;
  }
  return problem.str();
}

CheckedRange checkRange(const sensor_msgs::Range& message, bool over_range_is_no_echo) {
  constexpr double kNoEcho = std::numeric_limits<double>::infinity();
  if (checkSensor(message)) return rejected(Reject::kBadSensor);
  if (message.header.stamp.isZero()) return rejected(Reject::kNoStamp);

  CheckedRange checked;
  checked.range = message.range;
  checked.spec.field_of_view = std::min<double>(message.field_of_view, core::kPi);
  checked.spec.min_range = message.min_range;
  checked.spec.max_range = message.max_range;
  if (std::isnan(checked.range)) return rejected(Reject::kNan);
  if (checked.range == -kNoEcho) return rejected(Reject::kTooClose);
  if (message.min_range == message.max_range) {
    if (checked.range != kNoEcho) return rejected(Reject::kFixedDistance);
    // It detects from its face on: the way to the one distance is free.
    checked.spec.min_range = 0.0;
    return checked;
  }
  if (checked.range < checked.spec.min_range) return rejected(Reject::kBelowMinRange);
  if (checked.range > checked.spec.max_range && checked.range != kNoEcho) {
    if (!over_range_is_no_echo) return rejected(Reject::kAboveMaxRange);
    checked.range = kNoEcho;
  }
  return checked;
}

}  // namespace place_memory::node
