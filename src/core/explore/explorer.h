#ifndef PLACE_MEMORY_CORE_EXPLORE_EXPLORER_H
#define PLACE_MEMORY_CORE_EXPLORE_EXPLORER_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/explore/free_space.h"
#include "core/explore/frontiers.h"
#include "core/explore/grid_ways.h"
#include "core/explore/new_ground.h"
#include "core/explore/sight.h"
#include "core/explore/surveyed_map.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

struct ExplorerOptions {
  FreeSpaceOptions space;
  FrontierOptions frontiers;
  SightOptions sight;
  PatienceOptions patience;
  double most_distance = 0.0;  ///< drives no further before it goes home [m]; 0: no bound
  bool stay = false;           ///< ends where it is when it is done; false: goes home
  double looked_around = 0.6;  ///< where it was, nothing so near opens any more [m]
  double past = 1.0;           ///< once it is so far away [m]
  double near_target = 1.5;    ///< need not get nearer to a frontier where something bars it [m]
  double gain = 0.3;           ///< a square metre that opens is worth so much way [m]
  double constancy = 1.5;      ///< another frontier must be nearer by so much way [m]
  double doubt = 0.6;          ///< from so much uncertainty on a loop is closed first [m]
  double barrier = 0.3;        ///< radius of what bars the way [m]
  /// Where nothing else is left, it tries what looks as narrow as this share of `space.radius`.
  double squeeze = 0.5;
  /// Before it is done it sets out so often at the most to look at what was never nearer than 1 m.
  int closer_looks = 8;
  double worth_a_try = 1.5;  ///< what bars the way to less than this is not tried again [m^2]
};

/// Decides where a robot drives that is to see all of a building: to the frontiers of what it has
/// seen, the cheapest first; back to where it was sure of itself, where it can close a loop so and
/// doubts where it is; home, when nothing is left. It drives nothing itself.
///
/// Deterministic. A decision costs one pass over the cells of the map and Dijkstra's search over
/// those that are passable: who drives asks anew every metre or so.
class Explorer {
 public:
  enum class Aim { kFrontier, kLoop, kHome };

  struct Task {
    Aim aim = Aim::kFrontier;
    Pose2d target;
    std::vector<Pose2d> way;  ///< spots to be driven to straight, the target last
    double length = 0.0;      ///< of that way [m]
  };

  enum class Outcome {
    kUnderWay,
    kDone,          ///< nothing is left that it can reach, or by which it gets to new ground
    kBoundReached,  ///< most_distance is driven
    kBlocked,       ///< it does not get home
  };

  /// What could not be reached, and why.
  struct Left {
    Pose2d spot;
    std::string why;
  };

  /// Where the robot is and what it knows of itself.
  struct Moment {
    Pose2d robot;        ///< in the map
    double way = 0.0;    ///< driven until now [m], not falling
    double doubt = 0.0;  ///< 1 sigma of where it is in the map [m]
  };

  Explorer(const ExplorerOptions& options, const Pose2d& home)
      : options_(options), home_(home), ground_(options.patience) {}

  /// Decides anew: a task is there, or it is over.
  void decide(const SurveyedCells& map, const Moment& now);

  const std::optional<Task>& task() const { return task_; }
  /// The robot stands at the task's target. To be followed by decide().
  void arrived(const Moment& now);
  /// It does not get on towards `spot`, the next one of the way. To be followed by decide().
  void blocked(const Moment& now, const Pose2d& spot, const std::string& why);

  bool isOver() const { return outcome_ != Outcome::kUnderWay; }
  Outcome outcome() const { return outcome_; }
  /// Whether the robot is where it began.
  bool isHome() const { return is_home_; }
  /// Frontiers that can be reached, as of the newest decision.
  std::size_t frontiers() const { return reachable_; }
  /// As of the newest decision.
  const std::vector<Left>& left() const { return left_; }
  /// Loops that it went back to close.
  std::size_t loopsSought() const { return loops_sought_; }

 private:
  struct Barrier {
    MapDisc disc;  ///< of radius 0 while it is taken to be gone
    std::string why;
    int lifted = 0;  ///< times that it was tried whether it is gone
  };
  /// Where the robot was when it was sure where that is.
  struct SureSpot {
    Pose2d spot;
    double way;
  };

  void remember(const Moment& now);
  void lookAround(const Moment& now);
  std::vector<MapDisc> barred() const;
  bool chooseFrontier(const FreeSpace& space, const GridWays& ways,
                      const std::vector<Frontier>& frontiers, const Moment& now);
  bool chooseLoop(const FreeSpace& space, const GridWays& ways, const Moment& now);
  void noteGround(const FreeSpace& space, const std::vector<Pose2d>& trail, const Moment& now);
  bool squeeze(const SurveyedCells& map, const Moment& now);
  bool lookCloser(const SurveyedCells& map, const FreeSpace& space, const GridWays& ways,
                  const Moment& now);
  bool isLookedAt(const Pose2d& spot) const;
  FreeSpaceOptions slim() const;
  bool isWorthATry(const SurveyedCells& map, const Moment& now) const;
  bool liftBarriers(int most);
  bool goHome(const FreeSpace& space, const GridWays& ways, const Moment& now);
  void listLeft(const SurveyedCells& map, const FreeSpace& space, const GridWays& ways,
                const Moment& now);
  std::string whyLeft(const Pose2d& spot, const GridWays& anyhow, FreeSpace::Cell cell) const;
  void take(Aim aim, const FreeSpace& space, const GridWays& ways, FreeSpace::Cell cell);

  ExplorerOptions options_;
  Pose2d home_;
  std::optional<Task> task_;
  Outcome outcome_ = Outcome::kUnderWay;
  Outcome at_home_ = Outcome::kDone;  ///< that it is when the robot is home
  bool is_home_ = false;
  bool stood_at_home_ = false;  ///< as near as it is let drive, at the newest decision
  bool returns_ = false;
  std::size_t reachable_ = 0;
  std::vector<Left> left_;
  std::vector<MapDisc> looked_at_;
  std::optional<Pose2d> looks_;  ///< from where it looks now
  std::vector<Barrier> barriers_;
  std::vector<SureSpot> sure_;
  bool looks_closer_ = false;  ///< what its task is for
  int closer_looks_ = 0;       ///< times that it set out for that
  NewGround ground_;
  std::optional<double> gave_up_at_;  ///< way [m]
  double no_loop_before_ = 0.0;       ///< way [m]
  std::size_t loops_sought_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_EXPLORER_H
