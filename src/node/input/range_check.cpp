#include "node/input/range_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "place_memory/core/pose2d.h"

namespace place_memory::node {
namespace {

// Messages carry floats: pi as a float is above pi.
constexpr double kWidest = core::kPi * (1.0 + 1e-6);

CheckedRange rejected(Reject reject) {
  CheckedRange checked;
  checked.reject = reject;
  return checked;
}

}  // namespace

std::optional<std::string> checkSpec(const core::SonarSpec& spec) {
  const double fov = spec.field_of_view;
  const double min = spec.min_range;
  const double max = spec.max_range;
  std::ostringstream problem;
  if (!(fov > 0.0 && fov <= kWidest)) {
    problem << "field_of_view must be in (0, pi] rad, not " << fov
            << (fov > kWidest && fov <= 360.0 ? ": is it in degrees?" : "");
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

CheckedRange checkRange(const core::SonarSpec& spec, double range,
                        const config::ScanOptions& scan) {
  constexpr double kNoEcho = std::numeric_limits<double>::infinity();
  CheckedRange checked;
  checked.range = range;
  checked.spec = spec;
  checked.spec.field_of_view = std::min(spec.field_of_view, core::kPi);
  if (std::isnan(range)) return rejected(Reject::kNan);
  if (range == -kNoEcho) return rejected(Reject::kTooClose);
  if (spec.min_range == spec.max_range) {
    if (range != kNoEcho) return rejected(Reject::kFixedDistance);
    // It detects from its face on: the way to the one distance is free.
    checked.spec.min_range = 0.0;
    return checked;
  }
  if (range == 0.0 && spec.min_range > 0.0 && scan.zero_range_is_no_echo) {
    checked.range = kNoEcho;
    return checked;
  }
  if (range < spec.min_range) return rejected(Reject::kBelowMinRange);
  if (range > spec.max_range && range != kNoEcho) {
    if (!scan.over_range_is_no_echo) return rejected(Reject::kAboveMaxRange);
    checked.range = kNoEcho;
  }
  return checked;
}

}  // namespace place_memory::node
