#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/sensing/clock_watch.h"
#include "core/sensing/compass_offset.h"
#include "core/sensing/heading_history.h"
#include "core/sensing/newest_stamps.h"
#include "core/sensing/sweep_builder.h"
#include "node/input/adapted_reading.h"
#include "node/input/heading_check.h"
#include "node/input/sensor_registry.h"
#include "node/scan/compass_health.h"
#include "node/scan/problem_list.h"
#include "node/scan/reading_locator.h"
#include "node/scan/scan_status.h"
#include "node/scan/sensor_health.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::node {

/// Makes scans of messages.
///
/// It never waits. Messages come as they are received; a reading whose transforms are not there yet
/// is kept for scan/tf_timeout and tried again at each process(). Every time is ROS time. Not
/// thread-safe.
class ScanCollector {
 public:
  /// All must outlive the collector. `registry`: by which the sensors of readings are numbered.
  /// Throws std::invalid_argument naming a parameter out of range.
  ScanCollector(const config::Parameters& parameters, const tf2::BufferCore& buffer,
                const SensorRegistry& registry);

  /// Starts a scan, dropping one that is under way. Readings stamped before `start` are not of it.
  void begin(std::chrono::nanoseconds start, int headings, double step);
  bool collecting() const { return sweep_.has_value(); }
  /// Readings that come from now on are not of the scan.
  void close() { closed_ = true; }
  /// Drops the scan that is under way.
  void drop();

  /// `received` is the time at which the message came. Messages are taken at any time: headings are
  /// remembered, and the health of sensors is noted. One whose stamp is more than a second behind
  /// the newest of its sensor is left out.
  void addHeading(const CheckedHeading& heading, std::chrono::nanoseconds received);
  void addReading(const AdaptedReading& reading, std::chrono::nanoseconds received);

  /// ROS time was set back: what was heard before is of another time.
  void forgetTime();
  /// ROS time went back by so much and counts as one time all the same.
  void stepBack(std::chrono::nanoseconds step);

  /// Locates what can be located by now, and gives up what has waited too long.
  void process(std::chrono::nanoseconds now);

  /// Why the scan that is under way cannot go on.
  const std::optional<ScanOutcome>& failure() const { return failure_; }
  /// Readings wait for transforms.
  bool waiting() const { return !pending_.empty(); }

  /// What has come of the scan, were it to end now, at `end`; readings that still wait are not of
  /// it.
  ScanOutcome outcome(std::chrono::nanoseconds end) const;
  /// The scan as far as it has come, without a number; nothing before a reading and a heading are
  /// there.
  std::optional<core::Scan> snapshot(std::chrono::nanoseconds end) const;

  /// Used in the scan.
  std::size_t readings() const { return sweep_ ? sweep_->readings().size() : 0; }
  /// Readings left out of the scan.
  const RejectCounts& rejected() const { return rejected_; }
  /// Only while collecting.
  const core::SweepBuilder& sweep() const { return sweep_.value(); }
  const core::HeadingHistory& headings() const { return history_; }
  const ReadingLocator& locator() const { return locator_; }

  std::vector<SensorHealth> sensorHealth() const {
    return health_.report(registry_, time_.passed());
  }
  CompassHealth compassHealth() const { return compass_health_.report(time_.passed()); }

  /// What is wrong with inputs since problems().clear(), scan or no scan.
  ProblemList& problems() { return problems_; }
  /// Notes what is wrong with an input, in a sentence, for the scan too.
  void noteProblem(const std::string& input, const std::string& sentence);

 private:
  struct Pending {
    core::Measurement measurement;
    std::chrono::nanoseconds deadline{0};
  };

  std::optional<std::string> keepHeading(const CheckedHeading& heading,
                                         std::chrono::nanoseconds received);
  void checkStamp(AdaptedReading& reading, std::chrono::nanoseconds received);
  void use(const core::LocatedReading& reading);
  void reject(core::SensorId sensor, Reject reason);
  bool tooEarly(const core::Measurement& measurement) const;
  std::optional<double> compassOffset() const;
  core::Pose2d baseAtEnd(std::chrono::nanoseconds end) const;
  ScanOutcome tooFew() const;
  std::string leftOut() const;

  const config::Parameters& parameters_;
  const SensorRegistry& registry_;
  const core::SonarModel model_;
  const std::chrono::nanoseconds wait_;  // for transforms and headings

  core::ForwardTime time_;  // of the health
  core::HeadingHistory history_;
  ReadingLocator locator_;
  SensorHealthTable health_;
  CompassHealthCount compass_health_;
  core::NewestStamps newest_stamps_;
  ProblemList problems_;

  // Of the scan that is under way.
  std::optional<core::SweepBuilder> sweep_;
  std::optional<ScanOutcome> failure_;
  std::chrono::nanoseconds start_{0};
  std::deque<Pending> pending_;
  core::CompassOffset compass_offset_;
  RejectCounts rejected_{};
  bool closed_ = false;
  ProblemList scan_problems_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_COLLECTOR_H
