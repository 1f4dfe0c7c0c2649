#include "core/drive/leg_driver.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kTurnFirst = 0.4;   // off by more, it turns on the spot [rad]
constexpr double kTurnGain = 1.5;    // [1/s]
constexpr double kSlowDown = 0.6;    // it slows down over so much room [m]
constexpr double kCreep = 0.05;      // [m/s]
constexpr double kBackWay = 0.3;     // [m]
constexpr double kBackTime = 5.0;    // [s]
constexpr double kStuckTime = 15.0;  // without getting nearer [s]
constexpr double kBetter = 0.2;      // that is getting nearer [s]
constexpr double kBlindTime = 2.0;   // [s]
constexpr double kSideReach = 0.8;   // what is beside it so far ahead pushes it off [m]
constexpr double kSideRoom = 0.2;    // and so near beside its hull [m]
constexpr double kSidePush = 0.25;   // [rad/s]
constexpr double kTouchTime = 1.0;   // told to go for so long, it has not moved [s]
constexpr double kTouchWay = 0.02;   // further than this [m]
constexpr double kAway = 0.6;        // it turns away by so much [rad]
constexpr double kAwayWay = 0.3;     // and goes so far [m]
constexpr double kAwayTime = 3.0;    // in so much time at most [s]
constexpr int kMostSidesteps = 2;    // on one leg

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Velocity LegDriver::stop(State state, const std::string& why) {
  state_ = state;
  why_ = why;
  return {};
}

bool LegDriver::isStuck(double now, double error) {
  const double left =
      distance_ / options_.speed + std::min(std::abs(error), kPi) / options_.turn_rate;
  if (!least_left_ || left < *least_left_ - kBetter) {
    least_left_ = left;
    better_since_ = now;
  }
  return now - better_since_ > kStuckTime + options_.patience;
}

Velocity LegDriver::backOff(double now, const Pose2d& base, const EchoRing& echoes,
                            std::chrono::nanoseconds stamp) {
  if (!backed_from_) {
    backed_from_ = base;
    backs_since_ = now;
    state_ = State::kBackingOff;
  }
  const double way = std::hypot(base.x - backed_from_->x, base.y - backed_from_->y);
  const bool has_room =
      echoes.behind(stamp, options_.radius) > options_.radius + options_.clearance;
  if (way >= kBackWay || now - backs_since_ > kBackTime || !has_room) {
    return stop(State::kBlocked, why_);
  }
  return {-0.5 * options_.speed, 0.0};
}

Velocity LegDriver::go(double error, double room, const EchoRing& echoes,
                       std::chrono::nanoseconds stamp) {
  Velocity velocity;
  velocity.turn = kTurnGain * error;
  if (std::abs(error) < kTurnFirst) {
    const double most =
        std::min({options_.speed, options_.speed * room / kSlowDown, kCreep + 0.5 * distance_});
    velocity.forward = std::max(most, kCreep) * std::cos(error);
    const auto push = [&](double side) {
      const double gap = echoes.beside(stamp, side, kSideReach) - options_.radius;
      return std::clamp(1.0 - gap / kSideRoom, 0.0, 1.0);
    };
    velocity.turn += kSidePush * (push(-1.0) - push(1.0));
  }
  velocity.turn = std::clamp(velocity.turn, -options_.turn_rate, options_.turn_rate);
  return velocity;
}

bool LegDriver::touches(double now, const Pose2d& base, const Velocity& velocity) {
  const bool is_there =
      stands_at_ && std::hypot(base.x - stands_at_->x, base.y - stands_at_->y) <= kTouchWay;
  if (!is_there || velocity.forward <= 0.0) {
    stands_at_ = base;
    stands_since_ = now;
  }
  return now - stands_since_ > kTouchTime;
}

// To the side where there is more room; the second time to the other one.
void LegDriver::turnAway(double now, const Pose2d& base, const EchoRing& echoes,
                         std::chrono::nanoseconds stamp) {
  const double left = echoes.beside(stamp, 1.0, kSideReach);
  const double right = echoes.beside(stamp, -1.0, kSideReach);
  away_ = away_ != 0.0 ? -away_ : left >= right ? 1.0 : -1.0;
  // From the way to the target: from its heading the second turn would undo the first.
  const double to_target = std::atan2(target_.y - base.y, target_.x - base.x);
  sidestep_ = Sidestep{base, wrapAngle(to_target + away_ * kAway), now};
  stands_at_.reset();
}

Velocity LegDriver::sidestep(double now, const Pose2d& base, double room) {
  const double way = std::hypot(base.x - sidestep_->from.x, base.y - sidestep_->from.y);
  const double error = wrapAngle(sidestep_->heading - base.yaw);
  const bool has_turned = std::abs(error) < 0.5 * kTurnFirst;
  if (way >= kAwayWay || now - sidestep_->since > kAwayTime || (has_turned && room <= 0.0)) {
    sidestep_.reset();
    return {};
  }
  Velocity velocity;
  velocity.turn = std::clamp(kTurnGain * error, -options_.turn_rate, options_.turn_rate);
  if (has_turned) velocity.forward = 0.5 * options_.speed;
  return velocity;
}

Velocity LegDriver::update(std::chrono::nanoseconds stamp, const Pose2d& base,
                           const EchoRing& echoes) {
  if (isOver()) return {};
  const double now = seconds(stamp);
  distance_ = std::hypot(target_.x - base.x, target_.y - base.y);
  if (state_ == State::kBackingOff) return backOff(now, base, echoes, stamp);
  if (distance_ <= options_.arrived) return stop(State::kArrived, "");
  if (!seeing_since_ || !echoes.isBlind(stamp)) seeing_since_ = now;
  if (echoes.isBlind(stamp)) {
    if (now - *seeing_since_ < kBlindTime) return {};
    return stop(State::kBlind, "no sonar that looks ahead is heard");
  }
  const double error = wrapAngle(std::atan2(target_.y - base.y, target_.x - base.x) - base.yaw);
  if (isStuck(now, error)) {
    // What it touches it may not hear.
    why_ = "the robot does not get nearer";
    return backOff(now, base, echoes, stamp);
  }
  // What stands beyond the target is not in the way.
  const double ahead = echoes.ahead(stamp, options_.radius);
  const double room = ahead - options_.radius - options_.clearance;
  if (sidestep_) return sidestep(now, base, room);
  const bool is_barred =
      std::abs(error) < kTurnFirst && room <= 0.0 && ahead < distance_ + options_.radius;
  if (!is_barred) {
    yields_since_.reset();
    state_ = State::kGoing;
    const Velocity velocity = go(error, std::max(room, 0.0), echoes, stamp);
    if (!touches(now, base, velocity)) return velocity;
    if (sidesteps_++ < kMostSidesteps) {
      turnAway(now, base, echoes, stamp);
      return {};
    }
    why_ = "the robot does not get nearer: it touches something";
    return backOff(now, base, echoes, stamp);
  }
  stands_at_.reset();  // it stands of its own will
  if (!yields_since_) yields_since_ = now;
  state_ = State::kYielding;
  if (now - *yields_since_ < options_.patience) return {};
  why_ = "something stands in the way";
  return backOff(now, base, echoes, stamp);
}

}  // namespace place_memory::core
