#include "node/scan/scan_collector.h"

#include <algorithm>
#include <utility>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

// A scan waits for the sensors that were heard so shortly before it.
constexpr std::chrono::nanoseconds kLately = std::chrono::seconds(2);

// Nothing takes so long from a sensor to here: its clock is wrong.
constexpr std::chrono::nanoseconds kLongAgo = std::chrono::seconds(1);

// Inputs to which problems belong, beside the sensors by their names.
constexpr char kCompass[] = "compass";
constexpr char kLocation[] = "location";

std::chrono::nanoseconds latestCredible(std::chrono::nanoseconds received) {
  return received + core::kMaxDisorder;
}

std::string isTheClockRight(std::chrono::nanoseconds age) {
  return " stamped " + inSeconds(age) + " before they come: is the clock there right?";
}

std::string behindTheNewest(std::chrono::nanoseconds behind) {
  return "it is stamped " + inSeconds(behind) +
         " before the newest one: was its clock set back, as where a board restarts?";
}

}  // namespace

ScanCollector::ScanCollector(const config::Parameters& parameters, const tf2::BufferCore& buffer,
                             const SensorRegistry& registry)
    : parameters_(parameters),
      registry_(registry),
      model_(parameters.sonar),
      wait_(toNanoseconds(parameters.scan.tf_timeout)),
      history_(toNanoseconds(parameters.scan.heading_timeout)),
      locator_(parameters, buffer, history_) {}

void ScanCollector::begin(std::chrono::nanoseconds start, int headings, double step) {
  drop();
  time_.observe(start);
  sweep_.emplace(headings, step, health_.heardWithin(kLately, time_.passed()),
                 locator_.usesOdometry());
  start_ = start;
}

void ScanCollector::drop() {
  sweep_.reset();
  failure_.reset();
  pending_.clear();
  compass_offset_ = {};
  rejected_.fill(0);
  closed_ = false;
  scan_problems_.clear();
}

void ScanCollector::addHeading(const CheckedHeading& heading, std::chrono::nanoseconds received) {
  time_.observe(received);
  compass_health_.noteMessage(time_.passed());
  if (const auto problem = keepHeading(heading, received)) {
    noteProblem(kCompass, "heading left out: " + *problem);
    compass_health_.noteLeftOut(*problem, time_.passed());
  }
}

std::optional<std::string> ScanCollector::keepHeading(const CheckedHeading& heading,
                                                      std::chrono::nanoseconds received) {
  if (heading.problem) return heading.problem;
  if (received.count() == 0) return std::nullopt;  // simulated time does not run yet
  const std::chrono::nanoseconds stamp = heading.stamp;
  if (stamp > latestCredible(received)) {
    return "it is stamped more than a second ahead of the clock";
  }
  const core::TimeOrder order = history_.add(stamp, heading.yaw);
  if (order == core::TimeOrder::kBackwards) {
    return behindTheNewest(history_.newest()->stamp - stamp);
  }
  if (order == core::TimeOrder::kLate || !collecting()) return std::nullopt;
  const std::chrono::nanoseconds age = received - stamp;
  if (age > kLongAgo) noteProblem(kCompass, "headings are" + isTheClockRight(age));
  if (locator_.usesOdometry() && stamp >= start_) {
    compass_offset_.add(stamp, received + wait_, heading.yaw);
  }
  return std::nullopt;
}

void ScanCollector::addReading(const AdaptedReading& adapted, std::chrono::nanoseconds received) {
  time_.observe(received);
  health_.noteMessage(adapted, time_.passed());
  AdaptedReading reading = adapted;
  checkStamp(reading, received);
  const core::Measurement& measurement = reading.measurement;
  const bool taken = collecting() && !closed_;
  const bool before_scan = measurement.stamp < start_ && measurement.stamp.count() != 0;
  if (reading.reject) {
    if (taken && (!before_scan || reading.reject == Reject::kOld)) {
      reject(measurement.sensor, *reading.reject);
    } else {
      health_.noteReject(measurement.sensor, *reading.reject, time_.passed());
    }
    return;
  }
  if (!taken || before_scan) return;
  pending_.push_back({measurement, received + wait_});
}

void ScanCollector::checkStamp(AdaptedReading& reading, std::chrono::nanoseconds received) {
  const core::Measurement& measurement = reading.measurement;
  // Nothing of a sensor that makes no sense is believed; and those without a number are many.
  if (reading.reject == Reject::kBadSensor || measurement.sensor == kOtherSensors ||
      measurement.stamp.count() == 0) {
    return;
  }
  const auto credible = std::min(measurement.stamp, latestCredible(received));
  const core::TimeOrder order = newest_stamps_.note(measurement.sensor, credible);
  if (reading.reject) return;
  const std::chrono::nanoseconds age = received - measurement.stamp;
  const std::string name = registry_.nameOf(measurement.sensor);
  if (order == core::TimeOrder::kBackwards) {
    const auto behind = newest_stamps_.newest(measurement.sensor) - measurement.stamp;
    noteProblem(name, "reading of " + name + " left out: " + behindTheNewest(behind));
    reading.reject = Reject::kOld;
  } else if (collecting() && !closed_ && measurement.stamp < start_ && age > kLongAgo) {
    noteProblem(name, "readings of " + name + " are" + isTheClockRight(age));
    reading.reject = Reject::kOld;
  }
}

void ScanCollector::forgetTime() {
  history_.clear();
  newest_stamps_.clear();
  pending_.clear();
  compass_offset_.clearWaiting();
}

void ScanCollector::stepBack(std::chrono::nanoseconds step) {
  if (step <= core::kMaxDisorder) return;
  // Stamps that follow the clock are not stale.
  history_.clear();
  newest_stamps_.clear();
}

void ScanCollector::reject(core::SensorId sensor, Reject reason) {
  health_.noteReject(sensor, reason, time_.passed());
  ++rejected_.at(static_cast<std::size_t>(reason));
  sweep_->skip(sensor);
}

bool ScanCollector::tooEarly(const core::Measurement& measurement) const {
  // The next heading is needed too: between two of them the robot turns.
  const auto newest = history_.newest();
  return !locator_.usesOdometry() && (!newest || newest->stamp < measurement.stamp);
}

void ScanCollector::use(const core::LocatedReading& reading) {
  if (sweep_->add(reading) != core::SweepBuilder::Added::kJumped) return;
  failure_ = ScanOutcome{ScanStatus::kOdometryJump,
                         "odometry (" + parameters_.odom_frame + " to " + parameters_.base_frame +
                             ") jumped between two readings: the scan is dropped; scan again",
                         nullptr,
                         {}};
}

void ScanCollector::process(std::chrono::nanoseconds now) {
  time_.observe(now);
  if (!collecting()) return;
  compass_offset_.process(now, [this](std::chrono::nanoseconds stamp) -> std::optional<double> {
    std::string problem;
    const auto base = locator_.baseAt(stamp, problem);
    if (!base) return std::nullopt;
    return base->yaw;
  });
  std::deque<Pending> waiting;
  for (Pending& pending : pending_) {
    if (failure_) break;
    const bool last_chance = now >= pending.deadline;
    ReadingLocator::Located located;
    if (tooEarly(pending.measurement) && !last_chance) {
      located.reject = Reject::kNoHeading;
    } else if (sweep_->full()) {
      located.reject = Reject::kScanFull;
    } else {
      located = locator_.locate(pending.measurement);
    }
    if (!located.reject) {
      use(located.reading);
    } else if (ReadingLocator::mayCome(*located.reject) && !last_chance) {
      waiting.push_back(std::move(pending));
    } else {
      reject(pending.measurement.sensor, *located.reject);
      if (!located.problem.empty()) noteProblem(kLocation, "reading left out: " + located.problem);
    }
  }
  pending_.swap(waiting);
}

void ScanCollector::noteProblem(const std::string& input, const std::string& sentence) {
  problems_.note(input, sentence);
  if (collecting()) scan_problems_.note(input, sentence);
}

}  // namespace place_memory::node
