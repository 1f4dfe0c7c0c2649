#ifndef PLACE_MEMORY_CORE_DRIVE_LOST_SEARCH_H
#define PLACE_MEMORY_CORE_DRIVE_LOST_SEARCH_H

#include <chrono>
#include <optional>
#include <vector>

#include "core/drive/echo_ring.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

struct LostSearchOptions {
  double most_way = 20.0;    ///< it is given up then [m], > 0
  double most_time = 200.0;  ///< likewise [s], > 0
  double radius = 0.3;       ///< of the robot [m], > 0
  double clearance = 0.15;   ///< that it keeps to what it hears [m], > 0
  double step = 2.0;         ///< it drives no further at a time into what it does not know [m]
};

/// Decides where a robot drives that does not know where it is, so that it hears more of what is
/// about: to views that somebody advises, and without advice to where there is room and where it
/// has not been. It drives nothing itself. Everything is in odometry's frame.
class LostSearch {
 public:
  explicit LostSearch(const LostSearchOptions& options) : options_(options) {}

  /// Where the robot is, again and again while it searches.
  void follow(const Pose2d& odom_from_base, std::chrono::nanoseconds now);
  /// It does not search for a while: where it is, is known, and may get lost again.
  void pause() { last_.reset(); }

  /// Where it is to drive to straight; nothing: decide() is due.
  const std::optional<Pose2d>& target() const { return target_; }
  /// Whether that is what was advised.
  bool isAdvised() const { return is_advised_; }
  /// `advised`: spots to be driven to one after the other; may be empty. To be called after
  /// follow(). Without a target afterwards there is no way on.
  void decide(const std::vector<Pose2d>& advised, const EchoRing& echoes,
              std::chrono::nanoseconds now);
  /// The robot stands at the target.
  void arrived();
  /// It does not get on towards the target.
  void blocked();

  bool isOver() const { return way_ > options_.most_way || time_ > options_.most_time; }
  double way() const { return way_; }  ///< driven [m]

 private:
  struct Moment {
    Pose2d odom_from_base;
    std::chrono::nanoseconds stamp{0};
  };

  bool isBarred(const Pose2d& spot) const;
  std::optional<Pose2d> roomiest(const EchoRing& echoes, std::chrono::nanoseconds now) const;
  double newness(const Pose2d& spot) const;

  LostSearchOptions options_;
  std::optional<Moment> last_;
  std::optional<Pose2d> target_;
  bool is_advised_ = false;
  double way_ = 0.0;
  double time_ = 0.0;            // [s]
  std::vector<Pose2d> visited_;  // a spot each half metre or so
  std::vector<Pose2d> barred_;   // spots that it did not get to
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_DRIVE_LOST_SEARCH_H
