#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_INPUT_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_INPUT_H

#include <geometry_msgs/TransformStamped.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/sensing/clock_watch.h"
#include "node/drive/drive_feed.h"
#include "node/drive/drive_moment.h"
#include "node/input/message_intake.h"
#include "place_memory/core/scan.h"

namespace place_memory::node {

/// Where callbacks leave what a drive is made of, and the driver's thread fetches it. Thread-safe;
/// nobody who leaves something waits.
class DriveInput {
 public:
  /// What was left since the last time, in the order in which it came.
  struct Batch {
    bool jumped = false;  ///< time ran backwards before all of it
    std::vector<DriveMoment> moments;
    std::vector<geometry_msgs::TransformStamped> statics;
    std::vector<std::shared_ptr<const core::Scan>> scans;  ///< of a robot that stood
    DriveLosses losses;
    std::size_t overrun = 0;  ///< moments that were dropped, because too many waited
  };

  /// `parameters` must outlive it.
  explicit DriveInput(const config::Parameters& parameters);

  void take(const Taken& taken);
  void take(const geometry_msgs::TransformStamped& transform, bool is_static);
  void take(std::shared_ptr<const core::Scan> scan);

  /// Off, all but static transforms is dropped; on, it begins with those.
  void turn(bool on);
  /// Waits for something, for so long at the most.
  Batch fetch(std::chrono::nanoseconds longest);
  /// Ends a wait.
  void wake();

 private:
  bool observeTime(std::chrono::nanoseconds now);
  void add(DriveMoment moment, std::chrono::nanoseconds now);

  const config::Parameters& parameters_;
  std::mutex mutex_;
  std::condition_variable left_;
  bool on_ = false;
  bool woken_ = false;
  core::ClockWatch clock_;
  std::map<std::string, geometry_msgs::TransformStamped> statics_;  // by child
  Batch batch_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_INPUT_H
