#include "node/input/echo_dialect.h"

#include <algorithm>
#include <cmath>

namespace place_memory::node {
namespace {

constexpr double kHair = 1e-3;    // share of max_range
constexpr double kBeyond = 1e-2;  // likewise: nothing hears so little farther than it can
constexpr double kFloatMax = 0.99 * static_cast<double>(std::numeric_limits<float>::max());

constexpr int kRepeated = 3;
constexpr int kAgainAndAgain = 10;
constexpr int kTopRuns = 5;
// A wall at rest repeats too, but the ranges beside it are near, and it is at no special distance.
constexpr double kTopFrom = 0.8;  // share of max_range
constexpr double kGap = 0.02;     // share of the value

bool isMinusOne(double range) { return std::abs(range + 1.0) <= kHair; }

}  // namespace

bool isMaxRange(double range, double max_range) {
  return range >= (1.0 - kHair) * max_range && range <= (1.0 + kBeyond) * max_range;
}

std::optional<std::string> EchoDialect::noEcho(std::chrono::nanoseconds stamp, double range,
                                               const core::SonarSpec& spec,
                                               const config::NoEchoOptions& options) {
  // A sensor of one distance says only the infinities.
  if (!std::isfinite(range) || spec.min_range == spec.max_range) return std::nullopt;
  if (options.top && range >= kFloatMax) return "the largest float";
  if (options.top && isMaxRange(range, spec.max_range)) return "its max_range";
  if (options.zero && range == 0.0 && spec.min_range == 0.0) return "which no echo can have";
  if (options.zero && isMinusOne(range)) return "which no echo can have";
  if (stamp > newest_) follow(range, spec);
  newest_ = std::max(newest_, stamp);
  if (options.top && echoes_ && range > spec.max_range && outsideRepeats(range, kRepeated)) {
    return "which it repeats beyond its max_range";
  }
  if (options.zero && range < 0.0 && outsideRepeats(range, kRepeated)) return "which it repeats";
  if (options.top && topRepeats(range, spec)) return "which it repeats at the top of its range";
  return std::nullopt;
}

void EchoDialect::follow(double range, const core::SonarSpec& spec) {
  if (range < spec.min_range || range > spec.max_range) {
    outside_times_ = range == outside_ ? std::min(outside_times_ + 1, kAgainAndAgain) : 1;
    outside_ = range;
    return;
  }
  echoes_ = true;
  if (range > top_) {
    next_ = top_;
    top_ = range;
    top_runs_ = 0;
    at_top_ = false;
  }
  if (range < top_) {
    next_ = std::max(next_, range);
    at_top_ = false;
  } else if (!at_top_) {
    top_runs_ = std::min(top_runs_ + 1, kTopRuns);
    at_top_ = true;
  }
}

bool EchoDialect::topRepeats(double range, const core::SonarSpec& spec) const {
  return range == top_ && top_runs_ >= kTopRuns && range >= kTopFrom * spec.max_range &&
         next_ <= (1.0 - kGap) * range;
}

bool EchoDialect::outsideRepeats(double range, int times) const {
  return range == outside_ && outside_times_ >= times;
}

std::optional<double> EchoDialect::repeatedOutside() const {
  if (!outsideRepeats(outside_, kAgainAndAgain)) return std::nullopt;
  return outside_;
}

}  // namespace place_memory::node
