#ifndef PLACE_MEMORY_NODE_GO_EXPLORE_RUN_H
#define PLACE_MEMORY_NODE_GO_EXPLORE_RUN_H

#include <chrono>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/explore/explorer.h"
#include "core/explore/surveyed_map.h"
#include "node/go/robot_finder.h"
#include "node/go/survey_feed.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// One exploration: what is known of the building, where the robot is in it, and where it drives
/// next. It is told again and again where the robot is; it drives nothing itself.
///
/// Until there is a map, and wherever the robot is lost, it goes by odometry. Not thread-safe.
class ExploreRun {
 public:
  /// All must outlive it.
  struct Context {
    core::PlaceMemory& memory;
    SurveyFeed& feed;
    const config::Parameters& parameters;
  };

  /// `most_distance` [m], 0: no bound; `stay`: it does not come home.
  ExploreRun(const Context& context, double most_distance, bool stay);
  ~ExploreRun();
  ExploreRun(const ExploreRun&) = delete;
  ExploreRun& operator=(const ExploreRun&) = delete;

  /// Where odometry's frame is taken to lie in the map while nothing tells where it does.
  const core::Pose2d& mapFromOdom() const { return map_from_odom_; }

  /// The robot is there. Decides anew where that is due, which costs some ten milliseconds.
  void follow(const RobotFix& fix);
  /// The robot stands at the spot.
  void arrived();
  /// It does not get on towards the spot.
  void blocked(const std::string& why);

  /// Whether it has heard enough to begin.
  bool hasBegun() const { return explorer_.has_value(); }
  /// To be driven to straight; nothing before it has begun, and once it is over.
  std::optional<core::Pose2d> spot() const;
  const std::optional<core::Explorer::Task>& task() const { return explorer_->task(); }
  bool isOver() const { return explorer_ && explorer_->isOver(); }
  core::Explorer::Outcome outcome() const { return explorer_->outcome(); }
  /// The robot was carried, or its odometry was reset: nothing is decided any more.
  bool hasJumped() const { return odometry_jumped_; }
  /// For too long a way nothing has told where the robot is.
  bool isLost() const;

  bool isHome() const;
  std::size_t places() const { return made_.size(); }
  double way() const { return way_; }  ///< driven [m]
  std::size_t frontiers() const { return explorer_ ? explorer_->frontiers() : 0; }
  std::vector<core::Explorer::Left> left() const;

 private:
  void locate(const RobotFix& fix);
  void take(SurveyFeed::News news, std::chrono::nanoseconds now);
  void count(const core::MapChange& change);
  void surveyAnew();
  core::Explorer::Moment moment() const;

  const Context context_;
  core::ExplorerOptions options_;
  std::optional<core::SurveyedMap> survey_;
  std::optional<core::Explorer> explorer_;
  std::size_t at_ = 0;  ///< of the task's way

  std::optional<RobotFix> fix_;
  core::Pose2d map_from_odom_;
  core::Pose2d home_;     ///< in the map
  bool has_map_ = false;  ///< since it is known, or was, where the robot is
  bool becomes_known_ = false;
  bool odometry_jumped_ = false;
  double lost_from_ = 0.0;  ///< way at which that was known last [m]
  double doubt_ = 0.0;      ///< [m]
  double way_ = 0.0;
  double decided_at_ = 0.0;  ///< way [m]
  std::optional<std::chrono::nanoseconds> heard_since_;
  std::vector<SurveyFeed::Heard> before_map_;
  std::set<core::PlaceId> made_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_EXPLORE_RUN_H
