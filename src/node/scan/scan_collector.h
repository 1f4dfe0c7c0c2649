#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H

#include <ros/time.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/Range.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/sensing/heading_history.h"
#include "core/sensing/sweep_coverage.h"
#include "node/scan/compass_offset.h"
#include "node/scan/newest_stamps.h"
#include "node/scan/scan_status.h"
#include "node/scan/sensor_health.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::node {

/// Makes scans of messages: each reading is placed by tf, or by the heading where there is no
/// odometry, at its own stamp, so that a turning robot blurs nothing.
///
/// It never waits. Messages come as they are received; a reading whose transforms are not there yet
/// is kept for scan/tf_timeout and tried again at each process(). Not thread-safe.
class ScanCollector {
 public:
  static constexpr std::size_t kMaxReadings = 100000;

  /// Both must outlive the collector. Throws std::invalid_argument naming a parameter out of range.
  ScanCollector(const config::Parameters& parameters, const tf2::BufferCore& buffer);

  /// Starts a scan, dropping one that is under way. Readings stamped before `start` are not of it.
  void begin(const ros::Time& start, int headings, double step);
  bool collecting() const { return coverage_.has_value(); }
  /// Readings that come from now on are not of the scan.
  void close() { closed_ = true; }
  /// Drops the scan that is under way.
  void drop();

  /// `received` is the time at which the message came. Messages are taken at any time: headings are
  /// remembered, and the health of sensors is noted.
  void addHeading(const sensor_msgs::Imu& message, const ros::Time& received);
  void addRange(const sensor_msgs::Range& message, const ros::Time& received);

  /// Time was set back: what was heard before is of another time.
  void forgetTime();

  /// Places what can be placed by now, and gives up what has waited too long.
  void process(const ros::Time& now);

  /// Why the scan that is under way cannot go on.
  const std::optional<ScanOutcome>& failure() const { return failure_; }
  /// Readings wait for transforms.
  bool waiting() const { return !pending_ranges_.empty(); }

  /// What has come of the scan, were it to end now, at `end`; readings that still wait are not of
  /// it.
  ScanOutcome outcome(const ros::Time& end) const;
  /// The scan as far as it has come; nothing before a reading and a heading are there.
  std::optional<core::Scan> snapshot(const ros::Time& end) const;

  std::size_t readings() const { return placed_.size(); }
  /// Between the stamps of one used reading and the next, at most two seconds [s].
  double longestGap() const { return longest_gap_; }
  /// Readings left out of the scan, by Reject.
  const RejectCounts& rejected() const { return rejected_; }
  /// Only while collecting.
  const core::SweepCoverage& coverage() const { return coverage_.value(); }
  const core::HeadingHistory& headings() const { return history_; }
  const SensorHealthTable& health() const { return health_; }
  /// Problem with a transform or a heading since the last call, in a sentence; empty: none.
  std::string takeProblem();
  /// Whether time ran backwards since the last call: what tf remembers is then of another time.
  bool takeTimeJump();

 private:
  /// Waits for its transforms or its heading.
  struct Pending {
    std::string frame;
    ros::Time stamp;
    ros::Time deadline;
    core::SonarSpec spec;
    double range;
  };
  /// In the fixed frame: odometry's, or one with its axes along the compass and the base in its
  /// origin.
  struct Placed {
    ros::Time stamp;
    core::Pose2d base;
    core::SonarReading reading;
  };

  std::optional<Reject> rejectIfOld(const sensor_msgs::Range& message, const ros::Time& received);
  bool usesOdometry() const { return !parameters_.odom_frame.empty(); }
  std::optional<core::Pose2d> basePose(const ros::Time& stamp, std::string& problem) const;
  std::optional<Reject> place(const Pending& pending, std::string& problem);
  bool tooEarly(const Pending& pending) const;
  bool jumped(const Placed& reading, double gap) const;
  void use(const std::string& frame, const Placed& reading);
  void reject(const std::string& frame, Reject reason);
  void fail(ScanStatus status, const std::string& message);
  void timeRanBackwards(const std::string& source);
  std::optional<double> compassMinusFixed() const;
  core::Pose2d baseAtEnd(const ros::Time& end) const;
  ScanOutcome tooFew() const;
  std::string leftOut() const;

  const config::Parameters& parameters_;
  const tf2::BufferCore& buffer_;
  const core::SonarModel model_;

  core::HeadingHistory history_;
  SensorHealthTable health_;
  NewestStamps newest_stamps_;
  std::string problem_;
  bool time_jump_ = false;

  // Of the scan that is under way.
  std::optional<core::SweepCoverage> coverage_;
  std::optional<ScanOutcome> failure_;
  ros::Time start_;
  std::deque<Pending> pending_ranges_;
  CompassOffset compass_offset_;
  std::vector<Placed> placed_;
  double longest_gap_ = 0.0;
  RejectCounts rejected_{};
  bool closed_ = false;
  std::string scan_problem_;  // the latest
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H
