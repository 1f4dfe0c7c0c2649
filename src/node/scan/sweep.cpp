#include "node/scan/sweep.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

// A scan that is planned waits so long for a sensor to be heard, and where they are heard for the
// first time, for all of them.
constexpr std::chrono::nanoseconds kFirstSensor = std::chrono::seconds(2);
constexpr std::chrono::nanoseconds kAllSensors = std::chrono::seconds(1);

// A robot is not kept turning for readings of which none could be used so far.
constexpr std::chrono::nanoseconds kNothingUsed = std::chrono::seconds(5);

constexpr double kLongest = 3600.0;  // [s]

}  // namespace

Sweep::Step Sweep::update(std::chrono::nanoseconds now) {
  if (now.count() == 0) return {};
  if (started_.count() == 0) started_ = now;
  if (phase_ == ScanPhase::kWaitingForTime) {
    if (!plan(now)) return {};
    start(now);
  }
  if (collector_.failure()) return {std::nullopt, collector_.outcome(now)};
  if (toSeconds(now - started_) > request_.timeout) return {std::nullopt, timedOut(now)};
  return phase_ == ScanPhase::kListening ? listen(now) : turn(now);
}

bool Sweep::plan(std::chrono::nanoseconds now) {
  if (request_.headings > 0) return true;
  const std::vector<core::SensorMount> mounts = collector_.mounts();
  const std::chrono::nanoseconds waited = now - started_;
  const bool more_may_come = mounts.empty() || collector_.heardFor() < kAllSensors;
  const std::chrono::nanoseconds patience = mounts.empty() ? kFirstSensor : kAllSensors;
  const bool has_time = waited >= std::chrono::nanoseconds(0) &&
                        toSeconds(waited) < 0.5 * request_.timeout && waited < patience;
  if (more_may_come && has_time) return false;
  const core::SweepPlan plan = core::planSweep(mounts, request_.step);
  request_.headings = plan.headings;
  request_.step = plan.step;
  if (request_.longer_if_needed) {
    const double reckoned = core::reckonedSeconds(plan, parameters_.scan.turn_rate);
    request_.timeout = std::max(request_.timeout, std::min(2.0 * reckoned, kLongest));
  }
  plan_ = plan.reason;
  return true;
}

void Sweep::start(std::chrono::nanoseconds now) {
  if (request_.turn == config::Turn::kCmdVel) {
    const int headings = core::SweepCoverage(request_.headings, request_.step).target();
    turner_.emplace(headings, request_.step, parameters_.scan.turn_rate,
                    parameters_.scan.least_turn_rate);
    if (const auto compass = collector_.headings().newest()) compass_before_ = compass->yaw;
    phase_ = ScanPhase::kToFirst;
  } else {
    listening_.emplace(now, static_cast<std::size_t>(parameters_.scan.min_readings));
    collector_.begin(now, request_.headings, request_.step);
    phase_ = ScanPhase::kListening;
  }
}

Sweep::Step Sweep::listen(std::chrono::nanoseconds now) {
  if (!listening_->update(now, collector_.sweep())) return {};
  return {std::nullopt, withPlan(collector_.outcome(now))};
}

Sweep::Step Sweep::turn(std::chrono::nanoseconds now) {
  const std::optional<double> yaw = yawAt(now);
  if (!yaw) return stopWithoutYaw(now);
  int completed = 0;
  bool here_over = false;
  if (collector_.collecting()) {
    const core::SweepCoverage& coverage = collector_.sweep().coverage();
    completed = coverage.completed();
    here_over = completed == coverage.headings();
  }
  Step step;
  step.rate = turner_->update(now, *yaw, completed, here_over);
  turned_ = true;
  if (turner_->base().fault()) return {std::nullopt, disobeyed()};
  if (phase_ == ScanPhase::kToFirst && turner_->started()) {
    collector_.begin(now, request_.headings, request_.step);
    swept_from_ = now;
    phase_ = ScanPhase::kSweeping;
  }
  if (phase_ == ScanPhase::kSweeping && collector_.readings() == 0 &&
      now - swept_from_ > kNothingUsed) {
    return {std::nullopt, collector_.outcome(now)};
  }
  if (phase_ == ScanPhase::kSweeping && turner_->swept()) {
    collector_.close();
    phase_ = ScanPhase::kBack;
  }
  if (turner_->done()) step.outcome = withPlan(collector_.outcome(now));
  return step;
}

ScanOutcome Sweep::withPlan(ScanOutcome outcome) const {
  if (!plan_.empty() && outcome.scan) outcome.message += "; " + plan_;
  return outcome;
}

TurnSources Sweep::sources() const {
  const bool odometry = collector_.locator().usesOdometry();
  TurnSources sources;
  sources.command_topic = command_topic_;
  sources.listened = listened_;
  sources.yaw = odometry
                    ? "odometry (" + parameters_.odom_frame + " to " + parameters_.base_frame + ")"
                    : "the compass (" + parameters_.heading_topic + ")";
  sources.yaw_is_compass = !odometry;
  const auto compass = collector_.headings().newest();
  if (odometry && compass && compass_before_) {
    sources.compass = core::wrapAngle(compass->yaw - *compass_before_);
  }
  return sources;
}

ScanOutcome Sweep::disobeyed() const {
  return {ScanStatus::kBaseDisobeys, faultInWords(turner_->base(), sources()), nullptr, {}};
}

Sweep::Step Sweep::stopWithoutYaw(std::chrono::nanoseconds now) const {
  const bool may_come = toSeconds(now - started_) <= parameters_.scan.heading_timeout;
  if (may_come && !turned_) return {};
  const bool odometry = collector_.locator().usesOdometry();
  const std::string why =
      odometry
          ? "no fresh transform from " + parameters_.base_frame + " to " + parameters_.odom_frame +
                ": start what publishes odometry, or correct odom_frame and base_frame"
          : "no fresh heading on " + parameters_.heading_topic + ": does the compass run?";
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
  if (!plan_.empty()) text << "; " << plan_;
  if (sensed == 1 && request_.headings > 1 && phase_ == ScanPhase::kListening) {
    text << "; nothing turned the robot: let the node do it (turn), or ask for 1 heading";
  }
  if (turner_) {
    const std::string facts = sentAndTurned(turner_->base(), sources());
    if (!facts.empty()) text << "; " << facts;
  }
  const bool only_few = outcome.status == ScanStatus::kTooFewReadings &&
                        sensed >= collector_.sweep().coverage().target();
  const bool said_why = only_few || outcome.status == ScanStatus::kNoHeading ||
                        outcome.status == ScanStatus::kNoOdometry;
  return {said_why ? outcome.status : ScanStatus::kTimeout, text.str(), nullptr, {}};
}

}  // namespace place_memory::node
