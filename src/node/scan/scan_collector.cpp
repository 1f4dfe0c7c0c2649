#include "node/scan/scan_collector.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <utility>

#include "core/sensing/odometry_jump.h"
#include "node/input/heading_check.h"
#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

// A sonar that looks up or down more steeply says nothing about the plane.
constexpr double kLeastLevel = 0.1;

// A scan waits for the sensors that were heard so shortly before it.
constexpr double kLately = 2.0;  // [s]

// Nothing takes so long from a sensor to here: its clock is wrong.
constexpr double kLongAgo = 1.0;  // [s]

std::chrono::nanoseconds toNanoseconds(const ros::Time& time) {
  return std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec);
}

std::chrono::nanoseconds toNanoseconds(double seconds) {
  return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

std::string inSeconds(double seconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << seconds << " s";
  return text.str();
}

ros::Time latestCredible(const ros::Time& received) {
  return received + ros::Duration().fromNSec(core::kMaxDisorder.count());
}

}  // namespace

ScanCollector::ScanCollector(const config::Parameters& parameters, const tf2::BufferCore& buffer)
    : parameters_(parameters),
      buffer_(buffer),
      model_(parameters.sonar),
      history_(toNanoseconds(parameters.scan.heading_timeout)) {}

void ScanCollector::begin(const ros::Time& start, int headings, double step) {
  drop();
  std::set<std::string> sensors;
  for (const auto& [frame, health] : health_.sensors()) {
    const bool lately = std::abs(start.toSec() - health.last_received.toSec()) < kLately;
    if (lately && frame != SensorHealthTable::kOthers) sensors.insert(frame);
  }
  coverage_.emplace(headings, step, std::move(sensors));
  start_ = start;
}

void ScanCollector::drop() {
  coverage_.reset();
  failure_.reset();
  pending_ranges_.clear();
  compass_offset_ = {};
  placed_.clear();
  longest_gap_ = 0.0;
  rejected_.fill(0);
  closed_ = false;
  scan_problem_.clear();
}

void ScanCollector::addHeading(const sensor_msgs::Imu& message, const ros::Time& received) {
  const CheckedHeading heading = checkHeading(message);
  if (heading.problem) {
    problem_ = scan_problem_ = "heading left out: " + *heading.problem;
    return;
  }
  const ros::Time& stamp = message.header.stamp;
  if (stamp > latestCredible(received)) {
    problem_ = scan_problem_ =
        "heading left out: it is stamped more than a second ahead of the clock";
    return;
  }
  switch (history_.add(toNanoseconds(stamp), heading.yaw)) {
    case core::TimeOrder::kLate:
      return;
    case core::TimeOrder::kBackwards:
      timeRanBackwards(parameters_.heading_topic);
      break;
    case core::TimeOrder::kForward:
      break;
  }
  const double age = received.toSec() - stamp.toSec();
  if (collecting() && age > kLongAgo) {
    scan_problem_ =
        "headings are stamped " + inSeconds(age) + " before they come: is the clock there right?";
  }
  if (collecting() && usesOdometry() && stamp >= start_) {
    compass_offset_.add(stamp, received + ros::Duration(parameters_.scan.tf_timeout), heading.yaw);
  }
}

void ScanCollector::addRange(const sensor_msgs::Range& message, const ros::Time& received) {
  const ros::Time& stamp = message.header.stamp;
  const std::string& frame = message.header.frame_id;
  health_.noteMessage(message, received);
  CheckedRange checked = checkRange(message, parameters_.scan.over_range_is_no_echo);
  const auto credible = toNanoseconds(std::min(stamp, latestCredible(received)));
  // Nothing of a sensor that makes no sense is believed; and those without a frame are many.
  if (checked.reject != Reject::kBadSensor && !stamp.isZero() &&
      newest_stamps_.note(frame, credible) == core::TimeOrder::kBackwards) {
    timeRanBackwards(frame);
  }
  const bool taken = collecting() && !closed_;
  const bool before_scan = stamp < start_ && !stamp.isZero();
  if (taken && before_scan && !checked.reject) checked.reject = rejectIfOld(message, received);
  if (checked.reject) {
    if (taken && (!before_scan || checked.reject == Reject::kOld)) {
      reject(frame, *checked.reject);
    } else {
      health_.noteReject(frame, *checked.reject);
    }
    return;
  }
  if (!taken || before_scan) return;
  pending_ranges_.push_back({frame, stamp, received + ros::Duration(parameters_.scan.tf_timeout),
                             checked.spec, checked.range});
}

std::optional<Reject> ScanCollector::rejectIfOld(const sensor_msgs::Range& message,
                                                 const ros::Time& received) {
  // ros::Duration would not hold how far a wrong stamp may be off.
  const double age = received.toSec() - message.header.stamp.toSec();
  if (age <= kLongAgo) return std::nullopt;
  problem_ = scan_problem_ = "readings of " + message.header.frame_id + " are stamped " +
                             inSeconds(age) + " before they come: is the clock there right?";
  return Reject::kOld;
}

void ScanCollector::forgetTime() {
  history_.clear();
  newest_stamps_.clear();
  pending_ranges_.clear();
  compass_offset_.clearWaiting();
}

void ScanCollector::timeRanBackwards(const std::string& source) {
  time_jump_ = true;
  forgetTime();
  fail(ScanStatus::kTimeJump,
       "time ran backwards in the messages of " + source + ": the scan is dropped; scan again");
}

void ScanCollector::fail(ScanStatus status, const std::string& message) {
  if (collecting() && !failure_) failure_ = ScanOutcome{status, message, nullptr};
}

void ScanCollector::reject(const std::string& frame, Reject reason) {
  health_.noteReject(frame, reason);
  ++rejected_.at(static_cast<std::size_t>(reason));
  coverage_->skip(frame);
}

std::optional<core::Pose2d> ScanCollector::basePose(const ros::Time& stamp,
                                                    std::string& problem) const {
  if (usesOdometry()) {
    const auto base =
        lookupPlanar(buffer_, parameters_.odom_frame, parameters_.base_frame, stamp, problem);
    if (!base) return std::nullopt;
    return base->pose;
  }
  const std::optional<double> heading = history_.at(toNanoseconds(stamp));
  if (!heading) {
    problem = "no heading on " + parameters_.heading_topic + " near the stamp of a reading";
    return std::nullopt;
  }
  return core::Pose2d{0.0, 0.0, *heading};
}

bool ScanCollector::tooEarly(const Pending& pending) const {
  // The next heading is needed too: between two of them the robot turns.
  const auto newest = history_.newest();
  return !usesOdometry() && (!newest || newest->stamp < toNanoseconds(pending.stamp));
}

std::optional<Reject> ScanCollector::place(const Pending& pending, std::string& problem) {
  if (placed_.size() >= kMaxReadings) return Reject::kScanFull;
  const auto sensor =
      lookupPlanar(buffer_, parameters_.base_frame, pending.frame, pending.stamp, problem);
  if (!sensor) return Reject::kNoTransform;
  if (sensor->level < kLeastLevel) return Reject::kVertical;
  const auto base = basePose(pending.stamp, problem);
  if (!base) return usesOdometry() ? Reject::kNoOdometry : Reject::kNoHeading;

  Placed placed;
  placed.stamp = pending.stamp;
  placed.base = *base;
  placed.reading.sensor_pose = *base * sensor->pose;
  placed.reading.spec = pending.spec;
  placed.reading.spec.min_range *= sensor->level;
  placed.reading.spec.max_range *= sensor->level;
  placed.reading.range = pending.range * sensor->level;
  use(pending.frame, placed);
  return std::nullopt;
}

void ScanCollector::use(const std::string& frame, const Placed& reading) {
  // ros::Duration would not hold how far a wrong stamp may be off.
  const double gap =
      placed_.empty() ? 0.0 : std::abs(reading.stamp.toSec() - placed_.back().stamp.toSec());
  if (usesOdometry() && jumped(reading, gap)) {
    fail(ScanStatus::kOdometryJump,
         "odometry (" + parameters_.odom_frame + " to " + parameters_.base_frame +
             ") jumped between two readings: the scan is dropped; scan again");
    return;
  }
  coverage_->add(frame, reading.base.yaw);
  longest_gap_ = std::max(longest_gap_, std::min(gap, kLately));
  placed_.push_back(reading);
}

bool ScanCollector::jumped(const Placed& reading, double gap) const {
  return !placed_.empty() && core::odometryJumped(placed_.back().base, reading.base, gap);
}

void ScanCollector::process(const ros::Time& now) {
  if (!collecting()) return;
  compass_offset_.process(now, [this](const ros::Time& stamp) -> std::optional<double> {
    std::string problem;
    const auto base = basePose(stamp, problem);
    if (!base) return std::nullopt;
    return base->yaw;
  });
  std::deque<Pending> waiting;
  for (Pending& pending : pending_ranges_) {
    if (failure_) break;
    const bool last_chance = now >= pending.deadline;
    std::string problem;
    const std::optional<Reject> reason =
        tooEarly(pending) && !last_chance ? Reject::kNoHeading : place(pending, problem);
    if (!reason) continue;
    const bool may_come = *reason == Reject::kNoTransform || *reason == Reject::kNoOdometry ||
                          *reason == Reject::kNoHeading;
    if (may_come && !last_chance) {
      waiting.push_back(std::move(pending));
      continue;
    }
    reject(pending.frame, *reason);
    if (!problem.empty()) problem_ = scan_problem_ = "reading left out: " + problem;
  }
  pending_ranges_.swap(waiting);
}

std::optional<double> ScanCollector::compassMinusFixed() const {
  if (!usesOdometry()) return 0.0;
  if (const auto mean = compass_offset_.mean()) return mean;
  // A slow compass may not have spoken during a short scan.
  const std::optional<double> heading = history_.at(toNanoseconds(placed_.front().stamp));
  if (!heading) return std::nullopt;
  return *heading - placed_.front().base.yaw;
}

core::Pose2d ScanCollector::baseAtEnd(const ros::Time& end) const {
  std::string problem;
  if (const auto base = basePose(end, problem)) return *base;
  // Odometry is a little older than the clock, and the robot may have turned since the last
  // reading.
  ros::Time stamp;
  if (usesOdometry()) {
    const auto base = lookupNewest(buffer_, parameters_.odom_frame, parameters_.base_frame, stamp);
    if (base && stamp >= placed_.back().stamp) return base->pose;
  }
  return placed_.back().base;
}

std::optional<core::Scan> ScanCollector::snapshot(const ros::Time& end) const {
  if (placed_.empty()) return std::nullopt;
  const std::optional<double> offset = compassMinusFixed();
  if (!offset) return std::nullopt;

  const core::Pose2d& origin = placed_.front().base;
  const core::Pose2d fixed_from_scan{origin.x, origin.y, -*offset};
  const core::Pose2d scan_from_fixed = fixed_from_scan.inverse();
  core::Scan scan;
  for (const Placed& placed : placed_) {
    core::SonarReading reading = placed.reading;
    reading.sensor_pose = scan_from_fixed * reading.sensor_pose;
    scan.readings.push_back(reading);
  }
  scan.grid = model_.build(scan.readings, parameters_.grid);
  scan.odom_from_scan = usesOdometry() ? fixed_from_scan : core::Pose2d{};
  scan.robot_in_scan = scan_from_fixed * baseAtEnd(end);
  scan.begin = toNanoseconds(start_);
  scan.end = toNanoseconds(end);
  return scan;
}

std::string ScanCollector::takeProblem() { return std::exchange(problem_, {}); }

bool ScanCollector::takeTimeJump() { return std::exchange(time_jump_, false); }

}  // namespace place_memory::node
