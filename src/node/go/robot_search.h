#ifndef PLACE_MEMORY_NODE_GO_ROBOT_SEARCH_H
#define PLACE_MEMORY_NODE_GO_ROBOT_SEARCH_H

#include <chrono>
#include <cstddef>
#include <string>

#include "core/drive/lost_search.h"
#include "node/go/pilot.h"
#include "node/go/view_asker.h"

namespace place_memory::node {

/// Has a robot look about until it is known where on the map it is: drives it to the views that
/// part the places where it may be, and where no view does to where there is room. Goes by
/// odometry, and within bounds. For the thread of the pilot.
class RobotSearch {
 public:
  /// All must outlive it.
  RobotSearch(const Pilot::Context& context, const ViewAsker& asker, Pilot& pilot);
  ~RobotSearch();
  RobotSearch(const RobotSearch&) = delete;
  RobotSearch& operator=(const RobotSearch&) = delete;

  /// Whether one may be begun: something follows the drive, and the robot is driven by odometry.
  static bool isPossible(config::Mode mode, config::DriveBy by) {
    return mode != config::Mode::kOff && by == config::DriveBy::kCmdVel;
  }

  /// It begins, or goes on after it was known for a while where the robot is.
  void begin();

  /// To be called some twenty times a second. kArrived: it is known where the robot is; what else
  /// is over says in a sentence why that was not found out. The robot stands then.
  DriveReport update(std::chrono::nanoseconds now);

  /// What the robot does, for people.
  std::string inWords() const;

 private:
  bool decide(std::chrono::nanoseconds now);
  DriveReport end(DriveReport::State state, const std::string& why);

  const Pilot::Context context_;
  const ViewAsker& asker_;
  Pilot& pilot_;
  core::LostSearch search_;
  std::size_t candidates_ = 0;         // that the view parts which it drives to
  std::chrono::nanoseconds begun_{0};  // steady
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_ROBOT_SEARCH_H
