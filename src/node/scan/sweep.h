#ifndef PLACE_MEMORY_NODE_SCAN_SWEEP_H
#define PLACE_MEMORY_NODE_SCAN_SWEEP_H

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "config/parameters.h"
#include "core/sensing/listening_end.h"
#include "core/sensing/sweep_plan.h"
#include "core/sensing/sweep_turner.h"
#include "node/names/node_names.h"
#include "node/scan/scan_collector.h"
#include "node/scan/scan_goal.h"
#include "node/scan/scan_status.h"
#include "node/scan/turn_words.h"

namespace place_memory::node {

enum class ScanPhase {
  kWaitingForTime,  ///< simulated time has not begun, or no sensor was heard by which to plan
  kListening,       ///< something else turns the robot, or nothing
  kToFirst,         ///< the robot turns to the first heading; nothing is collected yet
  kSweeping,        ///< it turns from heading to heading
  kBack,            ///< every heading is over: it turns to where it began
};

/// The course of the scan that a goal asked for, from phase to phase.
class Sweep {
 public:
  /// Both references must outlive the sweep. `command_topic`, as it is resolved, is for people.
  Sweep(const ScanRequest& request, const config::Parameters& parameters, ScanCollector& collector,
        std::string command_topic = kCommandTopic)
      : request_(request),
        parameters_(parameters),
        collector_(collector),
        command_topic_(std::move(command_topic)) {}

  /// What is to be done now.
  struct Step {
    std::optional<double> rate;          ///< to turn the robot at, counter-clockwise [rad/s]
    std::optional<ScanOutcome> outcome;  ///< the scan is over
  };
  /// To be told the ROS time again and again, after the collector has processed what came until it.
  Step update(std::chrono::nanoseconds now);
  /// Whether anything listens to the velocities, for people.
  void setListened(bool listened) { listened_ = listened; }

  const ScanRequest& request() const { return request_; }
  ScanPhase phase() const { return phase_; }
  /// How far the robot is to turn, and why, in a sentence; empty where the goal says how far.
  const std::string& plan() const { return plan_; }
  /// 0 before time runs.
  std::chrono::nanoseconds started() const { return started_; }

 private:
  bool plan(std::chrono::nanoseconds now);
  void start(std::chrono::nanoseconds now);
  Step listen(std::chrono::nanoseconds now);
  Step turn(std::chrono::nanoseconds now);
  Step stopWithoutYaw(std::chrono::nanoseconds now) const;
  std::optional<double> yawAt(std::chrono::nanoseconds now) const;
  ScanOutcome disobeyed() const;
  ScanOutcome timedOut(std::chrono::nanoseconds now) const;
  ScanOutcome withPlan(ScanOutcome outcome) const;
  TurnSources sources() const;

  ScanRequest request_;
  const config::Parameters& parameters_;
  ScanCollector& collector_;
  std::string command_topic_;
  std::string plan_;
  ScanPhase phase_ = ScanPhase::kWaitingForTime;
  std::chrono::nanoseconds started_{0};
  std::chrono::nanoseconds swept_from_{0};  // the first heading, where the robot is turned
  std::optional<core::ListeningEnd> listening_;
  std::optional<core::SweepTurner> turner_;
  bool listened_ = true;
  bool turned_ = false;                   // the robot was given a rate
  std::optional<double> compass_before_;  // when the turn began [rad]
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SWEEP_H
