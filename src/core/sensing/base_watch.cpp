#include "core/sensing/base_watch.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kProgress = 0.005;    // [rad]; less is noise
constexpr double kMovement = 0.015;    // [rad]; by which the first turn shows
constexpr double kOtherWay = 0.035;    // [rad]; more than one step of a coarse odometry
constexpr double kFurther = 0.15;      // [rad]; more than a base that obeys late coasts
constexpr double kAtRest = 0.04;       // [rad]; a base that goes further does not rest
constexpr double kBeyondRest = 0.003;  // [rad]; what odometry has shown at rest it may show again
constexpr double kOtherWayFor = 0.2;   // [s]; then it is no noise
constexpr double kDrift = 0.012;       // [rad/s]; a gyro may say so of a base that stands
constexpr double kWay = 0.02;          // [rad]; shorter ways back and forth are noise
constexpr double kPatience = 0.6;      // [s]; after so long without progress the rate is raised
constexpr double kRaise = 2.0;         // by this factor
constexpr double kStandsAfter = 3.0;   // [s]
constexpr double kLongestLag = 1.0;    // [s]

bool sameSign(double a, double b) { return (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0); }

}  // namespace

void BaseWatch::noteRest(double turned) {
  rest_low_ = rested_ ? std::min(rest_low_, turned) : turned;
  rest_high_ = rested_ ? std::max(rest_high_, turned) : turned;
  rested_ = true;
  if (rest_high_ - rest_low_ > kAtRest) rest_low_ = rest_high_ = turned;
}

void BaseWatch::begin(double rate) {
  started_ = true;
  if (!rested_) noteRest(last_turned_);
  first_time_ = last_time_;
  first_turned_ = way_mark_ = last_turned_;
  beginRun(last_time_, last_turned_, rate);
}

void BaseWatch::beginRun(double now, double turned, double rate) {
  run_rate_ = rate;
  run_from_ = turned;
  run_best_ = 0.0;
  progress_ = at_top_ = now;
}

void BaseWatch::update(double now, double turned, double rate) {
  if (!started_ && rate == 0.0) noteRest(turned);
  if (!started_ && rate != 0.0) begin(rate);
  if (started_) {
    sent_way_ += std::abs(rate) * std::max(0.0, now - last_time_);
    if (std::abs(rate) > std::abs(highest_sent_)) highest_sent_ = rate;
    if (std::abs(turned - way_mark_) > kWay) {
      turned_way_ += std::abs(turned - way_mark_);
      way_mark_ = turned;
    }
    if (!has_moved_ && std::abs(turned - first_turned_) > kMovement) {
      has_moved_ = true;
      const double on_its_way = kMovement / std::abs(highest_sent_);
      lag_ = std::clamp(now - first_time_ - on_its_way, 0.0, kLongestLag);
    }
    if (!sameSign(rate, run_rate_)) {
      first_run_ = false;
      beginRun(now, turned, rate);
    }
    if (rate != 0.0) judge(now, turned, rate);
  }
  last_time_ = now;
  last_turned_ = turned;
}

void BaseWatch::judge(double now, double turned, double rate) {
  const double came = std::copysign(1.0, rate) * (turned - run_from_);
  if (came > kMovement) obeys_ = true;
  const bool leaves = first_run_ && !obeys_ && leavesRestTheOtherWay(now, turned, rate);
  if (leaves || came < (obeys_ ? -kFurther : -kOtherWay)) fault_ = Fault::kOtherWay;
  if (came > run_best_ + kProgress) {
    run_best_ = came;
    progress_ = at_top_ = now;
  }
  if (std::abs(rate) < max_rate_) at_top_ = now;
  if (now - at_top_ > kStandsAfter) fault_ = Fault::kStands;
  if (now - progress_ > kPatience + lag_) {
    least_rate_ = std::min(kRaise * std::max(least_rate_, std::abs(rate)), max_rate_);
    progress_ = now;
  }
}

bool BaseWatch::leavesRestTheOtherWay(double now, double turned, double rate) {
  const double beyond = rate > 0.0 ? rest_low_ - turned : turned - rest_high_;
  if (beyond <= kBeyondRest) {
    other_way_since_.reset();
    return false;
  }
  if (!other_way_since_) other_way_since_ = now;
  const double seconds = now - *other_way_since_;
  return seconds >= kOtherWayFor && beyond > kBeyondRest + kDrift * seconds;
}

}  // namespace place_memory::core
