#include "core/sensing/sweep_turner.h"

#include <algorithm>
#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kGain = 4.0;             // rate for an error [1/s]
constexpr double kLeastGain = 0.8;        // [1/s]
constexpr double kLagGain = 0.6;          // gain times lag at which a late base hardly overshoots
constexpr double kLeastRate = 0.1;        // share of the top rate at which a robot still turns
constexpr double kSlow = 0.04;            // [rad/s]; faster, a base that obeys late would overshoot
constexpr double kTolerance = kPi / 720;  // a quarter of a degree
constexpr double kLeastTolerance = 1e-3;  // [rad]; what a robot at kSlow may pass over in an update

// A robot stands that turns less for so long; it may still be turning from a scan before.
constexpr double kStill = 0.02;           // [rad]
constexpr double kStillFor = 0.25;        // [s]
constexpr double kLongestToSettle = 2.0;  // [s]
constexpr double kHeardAlreadyFor = 1.0;  // [s]; then it goes on from a heading it has been at

double leastRate(double max_rate, double least_rate) {
  return least_rate > 0.0 ? std::min(least_rate, max_rate) : std::min(kLeastRate * max_rate, kSlow);
}

}  // namespace

SweepTurner::SweepTurner(int headings, double step, double max_rate, double least_rate)
    : headings_(headings),
      step_(step),
      max_rate_(max_rate),
      tolerance_(std::clamp(0.1 * step, kLeastTolerance, kTolerance)),
      base_(leastRate(max_rate, least_rate), max_rate) {
  const bool full_turn = headings * step > 2.0 * kPi - 0.5 * step;
  first_ = full_turn ? 0.0 : -0.5 * step * (headings - 1);
}

double SweepTurner::update(std::chrono::nanoseconds now, double yaw, int completed,
                           bool here_over) {
  if (!start_)
    start_ = now;
  else
    turned_ += wrapAngle(yaw - last_yaw_);
  last_yaw_ = yaw;
  const double seconds = std::chrono::duration<double>(now - *start_).count();
  base_.update(seconds, turned_, sent_);

  if (phase_ == Phase::kSettle && stands(seconds)) {
    phase_ = Phase::kToFirst;
    aimAt(first_, 0);
  }
  if (phase_ != Phase::kSettle) {
    noteReached(seconds);
    goOn(seconds, completed, here_over);
    noteReached(seconds);
  }
  if (phase_ == Phase::kBack && reached_) phase_ = Phase::kDone;
  sent_ = rate();
  return sent_;
}

bool SweepTurner::stands(double now) {
  if (std::abs(turned_ - settled_at_) > kStill) {
    settled_at_ = turned_;
    settled_since_ = now;
  }
  return now - settled_since_ >= kStillFor || now > kLongestToSettle;
}

void SweepTurner::goOn(double now, int completed, bool here_over) {
  // A base that obeys late is still turning when its target is reached.
  if (phase_ == Phase::kToFirst && reached_ && now - reached_since_ >= base_.lag()) {
    phase_ = Phase::kSweep;
  }
  if (phase_ != Phase::kSweep) return;
  if (completed >= headings_) {
    phase_ = Phase::kBack;
    aimAt(2.0 * kPi * std::round(turned_ / (2.0 * kPi)), completed);
  } else if (reached_ && here_over &&
             (completed > completed_before_ || now - reached_since_ > kHeardAlreadyFor)) {
    // Counted from where the robot came to stand, which may be past the heading meant.
    const double passed = std::floor((turned_ - first_) / step_ + 0.5);
    aimAt(std::max(first_ + step_ * (passed + 1.0), target_ + step_), completed);
  }
}

void SweepTurner::aimAt(double target, int completed) {
  target_ = target;
  direction_ = std::copysign(1.0, target - turned_);
  completed_before_ = completed;
  reached_ = false;
}

void SweepTurner::noteReached(double now) {
  const double tolerance = phase_ == Phase::kSweep ? tolerance_ : kTolerance;
  const bool is_there = direction_ * (target_ - turned_) <= tolerance;
  if (is_there && !reached_) reached_since_ = now;
  reached_ = reached_ || is_there;
}

double SweepTurner::rate() const {
  if (phase_ == Phase::kSettle || reached_) return 0.0;
  const double gain =
      base_.lag() > 0.0 ? std::clamp(kLagGain / base_.lag(), kLeastGain, kGain) : kGain;
  const double error = direction_ * (target_ - turned_);
  return direction_ * std::clamp(gain * error, base_.leastRate(), max_rate_);
}

}  // namespace place_memory::core
