#include "node/scan/sweep.h"

#include <sstream>

#include "node/base/ros_time.h"

namespace place_memory::node {

Sweep::Step Sweep::update(std::chrono::nanoseconds now) {
  if (now.count() == 0) return {};
  if (phase_ == ScanPhase::kWaitingForTime) start(now);
  if (collector_.failure()) return {std::nullopt, collector_.outcome(now)};
  if (toSeconds(now - started_) > request_.timeout) return {std::nullopt, timedOut(now)};
  return phase_ == ScanPhase::kListening ? listen(now) : turn(now);
}

void Sweep::start(std::chrono::nanoseconds now) {
  started_ = now;
  if (request_.turn == config::Turn::kCmdVel) {
    const int headings = core::SweepCoverage(request_.headings, request_.step).target();
    turner_.emplace(headings, request_.step, parameters_.scan.turn_rate);
    phase_ = ScanPhase::kToFirst;
  } else {
    listening_.emplace(now, static_cast<std::size_t>(parameters_.scan.min_readings));
    collector_.begin(now, request_.headings, request_.step);
    phase_ = ScanPhase::kListening;
  }
}

Sweep::Step Sweep::listen(std::chrono::nanoseconds now) {
  if (!listening_->update(now, collector_.sweep())) return {};
  return {std::nullopt, collector_.outcome(now)};
}

Sweep::Step Sweep::turn(std::chrono::nanoseconds now) {
  const std::optional<double> yaw = yawAt(now);
  if (!yaw) return stopWithoutYaw(now);
  const int completed = collector_.collecting() ? collector_.sweep().coverage().completed() : 0;
  Step step;
  step.rate = turner_->update(*yaw, completed);
  turned_ = true;
  if (phase_ == ScanPhase::kToFirst && turner_->started()) {
    collector_.begin(now, request_.headings, request_.step);
    phase_ = ScanPhase::kSweeping;
  }
  if (phase_ == ScanPhase::kSweeping && turner_->swept()) {
    collector_.close();
    phase_ = ScanPhase::kBack;
  }
  if (turner_->done()) step.outcome = collector_.outcome(now);
  return step;
}

Sweep::Step Sweep::stopWithoutYaw(std::chrono::nanoseconds now) const {
  const bool may_come = toSeconds(now - started_) <= parameters_.scan.heading_timeout;
  if (may_come && !turned_) return {};
  const bool odometry = collector_.locator().usesOdometry();
  const std::string why = odometry ? "no fresh transform from " + parameters_.base_frame + " to " +
                                         parameters_.odom_frame
                                   : "no fresh heading on " + parameters_.heading_topic;
  return {std::nullopt, ScanOutcome{odometry ? ScanStatus::kNoOdometry : ScanStatus::kNoHeading,
                                    "the robot was stopped: " + why,
                                    nullptr,
                                    {}}};
}

std::optional<double> Sweep::yawAt(std::chrono::nanoseconds now) const {
  const auto newest = collector_.locator().newestBase();
  if (!newest || toSeconds(now - newest->stamp) > parameters_.scan.heading_timeout) {
    return std::nullopt;
  }
  return newest->pose.yaw;
}

ScanOutcome Sweep::timedOut(std::chrono::nanoseconds now) const {
  const bool collecting = collector_.collecting();
  const int sensed = collecting ? collector_.sweep().coverage().headings() : 0;
  ScanOutcome outcome{
      ScanStatus::kTimeout, "the robot never came to the first heading", nullptr, {}};
  if (collecting) outcome = collector_.outcome(now);

  std::ostringstream text;
  text << "not over after " << request_.timeout << " s: " << sensed << " of " << request_.headings
       << " headings were sensed; " << outcome.message;
  if (sensed == 1 && request_.headings > 1 && phase_ == ScanPhase::kListening) {
    text << "; nothing turned the robot: let the node do it (turn), or ask for 1 heading";
  }
  const bool only_few = outcome.status == ScanStatus::kTooFewReadings &&
                        sensed >= collector_.sweep().coverage().target();
  const bool said_why = only_few || outcome.status == ScanStatus::kNoHeading ||
                        outcome.status == ScanStatus::kNoOdometry;
  return {said_why ? outcome.status : ScanStatus::kTimeout, text.str(), nullptr, {}};
}

}  // namespace place_memory::node
