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
constexpr double kLetGoWay = 0.2;    // it goes back so far from what it touches [m]
constexpr double kLetGoTime = 3.0;   // in so much time at most [s]
constexpr double kAway = 0.8;        // turns away by so much [rad]
constexpr double kFarAway = 1.4;     // or by so much, where that helped to neither side [rad]
constexpr double kAwayWay = 0.35;    // and goes so far [m]
constexpr double kAwayTime = 5.0;    // in so much time at most [s]
constexpr int kMostSidesteps = 6;    // on one leg
constexpr int kMostInVain = 4;       // one after the other

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

// To the side where there is more room; to the other one where it did not get on that way.
void LegDriver::turnAway(double now, const Pose2d& base, const EchoRing& echoes,
                         std::chrono::nanoseconds stamp) {
  if (away_ == 0.0) {
    const double left = echoes.beside(stamp, 1.0, kSideReach);
    const double right = echoes.beside(stamp, -1.0, kSideReach);
    away_ = left >= right ? 1.0 : -1.0;
  }
  ++sidesteps_;
  const double to_target = std::atan2(target_.y - base.y, target_.x - base.x);
  const double turn = away_ * (in_vain_ < 2 ? kAway : kFarAway);
  sidestep_ = Sidestep{base, wrapAngle(to_target + turn), now};
  stands_at_.reset();
  better_since_ = now;  // a detour
}

Velocity LegDriver::sidestep(double now, const Pose2d& base, const EchoRing& echoes,
                             std::chrono::nanoseconds stamp) {
  if (!sidestep_->is_going) {
    const double way = std::hypot(base.x - sidestep_->from.x, base.y - sidestep_->from.y);
    const bool has_room = echoes.behind(stamp, options_.radius) > options_.radius + kLetGoWay;
    if (has_room && way < kLetGoWay && now - sidestep_->since < kLetGoTime) {
      return {-0.5 * options_.speed, 0.0};
    }
    sidestep_ = Sidestep{base, sidestep_->heading, now, true};
  }
  return goAside(now, base, echoes.ahead(stamp, options_.radius) - options_.radius);
}

Velocity LegDriver::goAside(double now, const Pose2d& base, double gap) {
  const double error = wrapAngle(sidestep_->heading - base.yaw);
  Velocity velocity;
  velocity.turn = std::clamp(kTurnGain * error, -options_.turn_rate, options_.turn_rate);
  if (std::abs(error) < 0.5 * kTurnFirst) velocity.forward = 0.5 * options_.speed;
  const double way = std::hypot(base.x - sidestep_->from.x, base.y - sidestep_->from.y);
  const bool is_barred = velocity.forward > 0.0 && gap <= options_.clearance;
  if (way >= kAwayWay) {
    in_vain_ = 0;
  } else if (is_barred || touches(now, base, velocity) || now - sidestep_->since > kAwayTime) {
    ++in_vain_;
    away_ = -away_;
  } else {
    return velocity;
  }
  sidestep_.reset();
  stands_at_.reset();
  return {};
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
  if (sidestep_) return sidestep(now, base, echoes, stamp);
  const bool is_barred =
      std::abs(error) < kTurnFirst && room <= 0.0 && ahead < distance_ + options_.radius;
  if (!is_barred) {
    yields_since_.reset();
    state_ = State::kGoing;
    const Velocity velocity = go(error, std::max(room, 0.0), echoes, stamp);
    if (!touches(now, base, velocity)) return velocity;
    if (sidesteps_ < kMostSidesteps && in_vain_ < kMostInVain) {
      turnAway(now, base, echoes, stamp);
      return {};
    }
    why_ = "the robot does not get nearer: it touches something";
    return backOff(now, base, echoes, stamp);
  }
  stands_at_.reset();  // of its own will
  if (!yields_since_) yields_since_ = now;
  state_ = State::kYielding;
  if (now - *yields_since_ < options_.patience) return {};
  why_ = "something stands in the way";
  return backOff(now, base, echoes, stamp);
}

}  // namespace place_memory::core
