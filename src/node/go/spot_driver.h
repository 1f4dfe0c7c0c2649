#ifndef PLACE_MEMORY_NODE_GO_SPOT_DRIVER_H
#define PLACE_MEMORY_NODE_GO_SPOT_DRIVER_H

#include <chrono>
#include <string>

#include "node/base/drive_lease.h"
#include "node/go/robot_finder.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// How it goes on the way to a spot.
struct DriveReport {
  enum class State {
    kGoing,
    kWaiting,  ///< for what stands in the way to go
    kBackingOff,
    kArrived,    ///< from here on the robot stands
    kBlocked,    ///< likewise
    kSilent,     ///< who drives does not answer, or no sonar that looks ahead is heard
    kPreempted,  ///< somebody else drives through the same server
    kAdrift,     ///< odometry jumped, or fell silent
    kLost,       ///< where the robot is, is not known
  };
  State state = State::kGoing;
  std::string why;        ///< from kBlocked on: in a sentence
  double distance = 0.0;  ///< left, as the crow flies [m]

  bool isOver() const { return state >= State::kArrived; }
};

/// What the robot does, in a word or two.
std::string inWords(const DriveReport& report);

/// Drives the robot to one spot of the map after the other. Told again and again where it is.
class SpotDriver {
 public:
  SpotDriver() = default;
  virtual ~SpotDriver() = default;
  SpotDriver(const SpotDriver&) = delete;
  SpotDriver& operator=(const SpotDriver&) = delete;

  /// `hold` must stay until stop().
  virtual void begin(const core::Pose2d& target, DriveLease::Hold& hold) = 0;
  /// The map has moved under the robot.
  virtual void moveTarget(const core::Pose2d& target) = 0;
  virtual DriveReport update(const RobotFix& fix, std::chrono::nanoseconds now) = 0;
  /// The robot stands for want of knowing where it is, for a moment.
  virtual void pause() = 0;
  virtual void stop() = 0;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_SPOT_DRIVER_H
