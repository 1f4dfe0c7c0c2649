#ifndef PLACE_MEMORY_CORE_DRIVE_LEG_DRIVER_H
#define PLACE_MEMORY_CORE_DRIVE_LEG_DRIVER_H

#include <chrono>
#include <optional>
#include <string>

#include "core/drive/echo_ring.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

struct LegDriverOptions {
  double speed = 0.3;       ///< at most [m/s], > 0
  double turn_rate = 0.6;   ///< at most [rad/s], > 0
  double radius = 0.3;      ///< of the robot [m], > 0
  double clearance = 0.15;  ///< that it keeps to what it hears ahead [m], > 0
  double patience = 5.0;    ///< it waits so long for what stands in the way to go [s], >= 0
  double arrived = 0.25;    ///< so near to the target the robot is there [m], > 0
};

struct Velocity {
  double forward = 0.0;  ///< [m/s]
  double turn = 0.0;     ///< counter-clockwise [rad/s]
};

/// Drives a robot straight to a spot: turns towards it, goes, slows down before what the sonars
/// hear ahead, waits for it to go, and if it does not backs off and says that the way is blocked.
/// Where the robot does not move though nothing is heard ahead, it touches something with its side:
/// it turns away from that, and goes on a little before it heads for the spot again; if that does
/// not help it backs off too. A feedback controller: it is told again and again where the robot is,
/// and answers with a velocity.
class LegDriver {
 public:
  enum class State {
    kGoing,
    kYielding,  ///< stands before something
    kBackingOff,
    kArrived,  ///< from here on the robot stands
    kBlocked,  ///< likewise
    kBlind,    ///< likewise: no sonar that looks ahead was heard for a while
  };

  /// `target` and later poses in one frame.
  LegDriver(const LegDriverOptions& options, const Pose2d& target)
      : options_(options), target_(target) {}

  /// The map has moved under the robot.
  void setTarget(const Pose2d& target) { target_ = target; }

  Velocity update(std::chrono::nanoseconds now, const Pose2d& base, const EchoRing& echoes);

  State state() const { return state_; }
  bool isOver() const { return state_ >= State::kArrived; }
  /// Why the way is blocked, or the robot blind, in a sentence; "" before.
  const std::string& why() const { return why_; }
  /// To the target, at the newest update [m].
  double distance() const { return distance_; }

 private:
  Velocity stop(State state, const std::string& why);
  Velocity backOff(double now, const Pose2d& base, const EchoRing& echoes,
                   std::chrono::nanoseconds stamp);
  Velocity go(double error, double room, const EchoRing& echoes, std::chrono::nanoseconds stamp);
  bool isStuck(double now, double error);
  bool touches(double now, const Pose2d& base, const Velocity& velocity);
  void turnAway(double now, const Pose2d& base, const EchoRing& echoes,
                std::chrono::nanoseconds stamp);
  Velocity sidestep(double now, const Pose2d& base, double room);
  struct Sidestep {
    Pose2d from;
    double heading = 0.0;  ///< in the frame of the poses [rad]
    double since = 0.0;    ///< [s]
  };

  LegDriverOptions options_;
  Pose2d target_;
  State state_ = State::kGoing;
  std::string why_;
  double distance_ = 0.0;
  std::optional<double> yields_since_;  ///< [s]
  std::optional<Pose2d> backed_from_;
  double backs_since_ = 0.0;            ///< [s]
  std::optional<double> least_left_;    ///< of way and turn, each in seconds [s]
  double better_since_ = 0.0;           ///< [s]
  std::optional<double> seeing_since_;  ///< newest moment that it was not blind, or the first [s]
  std::optional<Pose2d> stands_at_;     ///< since it was told to go and did not
  double stands_since_ = 0.0;           ///< [s]
  std::optional<Sidestep> sidestep_;
  double away_ = 0.0;  ///< side to which it turned the last time: 1 left, -1 right
  int sidesteps_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_DRIVE_LEG_DRIVER_H
