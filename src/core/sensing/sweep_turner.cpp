#include "core/sensing/sweep_turner.h"

#include <algorithm>
#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kGain = 4.0;             // rate for an error [1/s]
constexpr double kLeastRate = 0.1;        // share of the top rate at which a robot still turns
constexpr double kSlow = 0.04;            // [rad/s]; faster, a base that obeys late would overshoot
constexpr double kTolerance = kPi / 720;  // a quarter of a degree
constexpr double kLeastTolerance = 1e-3;  // [rad]; what a robot at kSlow may pass over in an update

}  // namespace

SweepTurner::SweepTurner(int headings, double step, double max_rate)
    : headings_(headings),
      step_(step),
      max_rate_(max_rate),
      tolerance_(std::clamp(0.1 * step, kLeastTolerance, kTolerance)) {
  const bool full_turn = headings * step > 2.0 * kPi - 0.5 * step;
  first_ = full_turn ? 0.0 : -0.5 * step * (headings - 1);
}

double SweepTurner::target(int completed) const {
  switch (phase_) {
    case Phase::kToFirst:
      return first_;
    case Phase::kSweep:
      return first_ + step_ * std::min(completed, headings_ - 1);
    default:
      return 2.0 * kPi * std::round(turned_ / (2.0 * kPi));
  }
}

double SweepTurner::update(double yaw, int completed) {
  if (last_yaw_) turned_ += wrapAngle(yaw - *last_yaw_);
  last_yaw_ = yaw;

  const auto reached = [&] {
    const double tolerance = phase_ == Phase::kSweep ? tolerance_ : kTolerance;
    return std::abs(target(completed) - turned_) <= tolerance;
  };
  if (phase_ == Phase::kToFirst && reached()) phase_ = Phase::kSweep;
  if (phase_ == Phase::kSweep && completed >= headings_) phase_ = Phase::kBack;
  if (phase_ == Phase::kBack && reached()) phase_ = Phase::kDone;
  if (reached()) return 0.0;

  const double error = target(completed) - turned_;
  const double least = std::min(kLeastRate * max_rate_, kSlow);
  const double rate = std::clamp(kGain * std::abs(error), least, max_rate_);
  return std::copysign(rate, error);
}

}  // namespace place_memory::core
