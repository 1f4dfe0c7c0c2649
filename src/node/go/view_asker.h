#ifndef PLACE_MEMORY_NODE_GO_VIEW_ASKER_H
#define PLACE_MEMORY_NODE_GO_VIEW_ASKER_H

#include <tf2/buffer_core.h>

#include <functional>
#include <memory>
#include <vector>

#include "config/parameters.h"
#include "core/views/view_advice.h"
#include "node/drive/map_driver.h"
#include "node/go/robot_finder.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// What a scan was taken for.
struct ScanAnswer {
  core::Verdict verdict = core::Verdict::kUnknown;
  std::vector<core::PlaceMatch> matches;
  core::EvidenceGrid grid;
  core::Pose2d odom_from_scan;
  core::Pose2d robot_in_scan;
};

/// Asks the memory what the robot should look at next while it is not sure where it is: by the
/// belief of the drive (mode map or localize), or by the newest scan that was recognized.
/// Thread-safe.
class ViewAsker {
 public:
  /// All must outlive it.
  struct Context {
    const config::Parameters& parameters;
    const tf2::BufferCore& buffer;
    const core::PlaceMemory& memory;
    const MapDriver& driver;
    const RobotFinder& finder;
    std::function<std::shared_ptr<const ScanAnswer>()> newest_answer;
  };

  explicit ViewAsker(Context context) : context_(std::move(context)) {}

  struct Asked {
    core::ViewAdvice advice;
    core::Pose2d odom_from_base;  ///< when it was asked: what bearings and spots of a view go by
  };
  Asked ask() const;

 private:
  /// What is known of where the robot is; the candidates as of an earlier moment.
  struct Known {
    core::ViewQuestion question;
    core::Pose2d odom_from_base;  ///< at that moment
  };
  Known byBelief() const;
  Known byAnswer() const;
  bool isSure() const;

  const Context context_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_VIEW_ASKER_H
