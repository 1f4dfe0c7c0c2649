#ifndef PLACE_MEMORY_CORE_DRIVE_GOAL_RUN_H
#define PLACE_MEMORY_CORE_DRIVE_GOAL_RUN_H

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/place_map.h"
#include "place_memory/core/routes.h"

namespace place_memory::core {

/// Goes to a place leg by leg (ELDEN, paper 10): plans a route, has each leg driven, and where one
/// is found blocked tells its link, goes back to where the leg began and plans anew without it.
/// Where it cannot go back either, or does not get to the first place, it begins at another place
/// about it, three times at the most. It drives nothing itself.
class GoalRun {
 public:
  using Avoided = std::vector<std::pair<PlaceId, PlaceId>>;

  struct Wish {
    PlaceId from = kNoPlace;           ///< kNoPlace: from where the robot is
    Avoided avoided;                   ///< links that were found blocked
    std::vector<PlaceId> unreachable;  ///< it does not get to these from where it is
  };

  struct Hooks {
    std::function<RoutePlan(const Wish& wish)> plan;
    std::function<void(const Traversal&)> report;
  };

  enum class Outcome {
    kUnderWay,
    kReached,
    kNoRoute,    ///< no way leads there, or none is left
    kNotThere,   ///< there is no such place, or it was removed
    kLost,       ///< where the robot is, is not known
    kBlocked,    ///< it gets neither on nor back
    kSilent,     ///< who drives does not answer, or hears nothing
    kPreempted,  ///< something else drives the robot now
    kCanceled,
    kFailed,  ///< an error of the node's
  };

  struct Leg {
    PlaceId from = kNoPlace;  ///< kNoPlace: from where the robot stands, which is at no place
    PlaceId to = kNoPlace;    ///< kNoPlace: to a goal that is a pose
    std::string label;        ///< of `to`
    Pose2d target;            ///< in the map
    bool back = false;        ///< to where a blocked leg began
  };

  /// `goal`: where beyond the last place the robot is to stand.
  GoalRun(Hooks hooks, std::optional<Pose2d> goal, std::string source);

  /// From where the robot stands. A leg is there, or the goal is over.
  void begin(const Pose2d& robot, std::chrono::nanoseconds now);

  const std::optional<Leg>& leg() const { return leg_; }
  void arrived(std::chrono::nanoseconds now);
  void blocked(const std::string& why, std::chrono::nanoseconds now);
  /// Where the next place or the goal is gone, the route is planned anew or the run is over.
  void placeRemoved(PlaceId id, std::chrono::nanoseconds now);
  /// The map has changed: names and poses are those of now, and places that are gone are removed.
  void follow(const std::function<std::optional<Place>(PlaceId)>& find,
              std::chrono::nanoseconds now);
  void end(Outcome outcome, const std::string& message);

  bool isOver() const { return outcome_ != Outcome::kUnderWay; }
  Outcome outcome() const { return outcome_; }
  const std::string& message() const { return message_; }
  /// The leg that failed last, in words, and why; "" where none did.
  const std::string& failedLeg() const { return failed_leg_; }
  /// Links that were found blocked, in words, in their order.
  const std::vector<std::string>& tried() const { return tried_; }
  std::size_t legsDone() const { return legs_done_; }
  /// Legs that are left, the current one included.
  std::size_t legsLeft() const;
  /// Expected time until the goal is reached, where `distance` of the leg is left [m], [s].
  double timeLeft(double distance) const;
  /// The current leg; "" without one.
  std::string legInWords() const { return leg_ ? inWords(*leg_) : std::string(); }

 private:
  /// kNoPlace: from where the robot is, and first of all to the place where the route begins.
  void planFrom(PlaceId place, std::chrono::nanoseconds now);
  void goToStart(RoutePlan plan, std::chrono::nanoseconds now);
  void beginElsewhere(const Leg& failed, std::chrono::nanoseconds now);
  void endBlocked();
  void next(std::chrono::nanoseconds now);
  void take(Leg leg, std::chrono::nanoseconds now);
  std::string inWords(const Leg& leg) const;
  std::string labelOf(PlaceId id) const;

  Hooks hooks_;
  std::optional<Pose2d> goal_;
  std::string source_;
  RoutePlan plan_;
  std::size_t at_ = 0;  ///< index of the route's place where the current leg begins
  std::optional<Leg> leg_;
  std::chrono::nanoseconds leg_begun_{0};
  Avoided avoided_;
  std::vector<PlaceId> unreachable_;  // from where it stands since it got there
  int elsewhere_ = 0;                 // times that it began at another place
  Outcome outcome_ = Outcome::kUnderWay;
  std::string message_;
  std::string failed_leg_;
  std::vector<std::string> tried_;
  std::size_t legs_done_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_DRIVE_GOAL_RUN_H
