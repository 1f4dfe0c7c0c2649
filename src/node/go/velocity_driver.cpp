#include "node/go/velocity_driver.h"

namespace place_memory::node {
namespace {

using State = DriveReport::State;

State stateOf(core::LegDriver::State state) {
  switch (state) {
    case core::LegDriver::State::kGoing:
      return State::kGoing;
    case core::LegDriver::State::kYielding:
      return State::kWaiting;
    case core::LegDriver::State::kBackingOff:
      return State::kBackingOff;
    case core::LegDriver::State::kArrived:
      return State::kArrived;
    case core::LegDriver::State::kBlocked:
      return State::kBlocked;
    case core::LegDriver::State::kBlind:
      break;
  }
  return State::kSilent;
}

}  // namespace

VelocityDriver::VelocityDriver(const config::DriveOptions& options, EchoListener& echoes)
    : echoes_(echoes) {
  options_.speed = options.speed;
  options_.turn_rate = options.turn_rate;
  options_.radius = options.radius;
  options_.clearance = options.clearance;
  options_.patience = options.patience;
}

VelocityDriver::~VelocityDriver() { stop(); }

void VelocityDriver::begin(const core::Pose2d& target, DriveLease::Hold& hold) {
  if (!leg_) echoes_.begin();
  hold_ = &hold;
  leg_.emplace(options_, target);
}

void VelocityDriver::moveTarget(const core::Pose2d& target) {
  if (leg_) leg_->setTarget(target);
}

DriveReport VelocityDriver::update(const RobotFix& fix, std::chrono::nanoseconds now) {
  const core::Velocity velocity = leg_->update(now, fix.map_from_base, echoes_.ring());
  hold_->drive(velocity.forward, velocity.turn);
  return {stateOf(leg_->state()), leg_->why(), leg_->distance()};
}

void VelocityDriver::pause() {
  if (hold_ != nullptr) hold_->stop();
}

void VelocityDriver::stop() {
  if (!leg_) return;
  hold_->stop();
  hold_ = nullptr;
  leg_.reset();
  echoes_.end();
}

}  // namespace place_memory::node
