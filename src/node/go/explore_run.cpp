#include "node/go/explore_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "config/memory_options.h"
#include "core/sensing/odometry_jump.h"
#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

constexpr double kMapCell = 0.1;       // of the map that is explored by [m]
constexpr double kThicker = 0.15;      // than they are, things look on the map [m]
constexpr double kDecideEvery = 0.5;   // of the way [m]
constexpr double kListen = 0.6;        // before the first decision [s]
constexpr double kAtHome = 0.75;       // [m]
constexpr double kLostDoubt = 3.0;     // [m]
constexpr double kMostLostWay = 20.0;  // driven by odometry alone [m]

core::ExplorerOptions explorerOptions(const config::Parameters& parameters, double most_distance,
                                      bool stay) {
  core::ExplorerOptions options;
  options.space.radius = std::max(options.space.radius, parameters.drive.radius - kThicker);
  options.most_distance = most_distance;
  options.stay = stay;
  return options;
}

// One that is gone by now, or cannot be read, is not on the map.
std::shared_ptr<const core::EvidenceGrid> gridOf(const core::PlaceMemory& memory,
                                                 core::PlaceId id) {
  try {
    return std::make_shared<const core::EvidenceGrid>(memory.grid(id));
  } catch (const core::PlaceMemoryError&) {
    return nullptr;
  }
}

}  // namespace

ExploreRun::ExploreRun(const Context& context, double most_distance, bool stay)
    : context_(context), options_(explorerOptions(context.parameters, most_distance, stay)) {
  context_.feed.begin();
  surveyAnew();
}

ExploreRun::~ExploreRun() { context_.feed.end(); }

void ExploreRun::surveyAnew() {
  core::FusedMapOptions options = config::fusedMapOptions(context_.parameters);
  options.resolution = kMapCell;
  survey_.emplace(options, context_.parameters.grid, context_.parameters.sonar,
                  [&memory = context_.memory](core::PlaceId id) { return gridOf(memory, id); });
}

void ExploreRun::follow(const RobotFix& fix) {
  locate(fix);
  if (odometry_jumped_) return;
  take(context_.feed.fetch(), fix.stamp);
  if (!explorer_) {
    if (!heard_since_ || toSeconds(fix.stamp - *heard_since_) < kListen) return;
    explorer_.emplace(options_, home_);
  }
  if (explorer_->isOver()) return;
  if (explorer_->task() && way_ - decided_at_ < kDecideEvery) return;
  explorer_->decide(survey_->cells(map_from_odom_), moment());
  decided_at_ = way_;
  at_ = 0;
}

// The map's frame is laid once its first place is: what was decided before went by odometry's.
void ExploreRun::locate(const RobotFix& fix) {
  if (fix_) {
    odometry_jumped_ =
        odometry_jumped_ || core::odometryJumped(fix_->odom_from_base, fix.odom_from_base,
                                                 std::max(toSeconds(fix.stamp - fix_->stamp), 0.0));
    const core::Pose2d motion = fix_->odom_from_base.inverse() * fix.odom_from_base;
    if (!odometry_jumped_) way_ += std::hypot(motion.x, motion.y);
  } else {
    home_ = map_from_odom_ * fix.odom_from_base;
  }
  fix_ = fix;
  if (fix.is_assumed) return;
  lost_from_ = way_;
  const core::Pose2d map_from_odom = fix.map_from_base * fix.odom_from_base.inverse();
  if (!has_map_) {
    has_map_ = becomes_known_ = true;
    home_ = map_from_odom * map_from_odom_.inverse() * home_;
  }
  map_from_odom_ = map_from_odom;
}

void ExploreRun::take(SurveyFeed::News news, std::chrono::nanoseconds now) {
  doubt_ = news.doubt;
  if (!heard_since_ && !news.heard.empty()) heard_since_ = now;
  if (becomes_known_) {
    becomes_known_ = false;
    surveyAnew();
    for (const core::Place& place : context_.memory.map().places) survey_->add(place);
    for (const auto& [odom_from_base, reading] : before_map_) {
      survey_->hear(odom_from_base, reading);
    }
    before_map_.clear();
    if (explorer_) explorer_.emplace(options_, home_);
  }
  for (const core::MapChange& change : news.changes) {
    count(change);
    if (has_map_) survey_->apply(change);
  }
  for (const auto& [odom_from_base, reading] : news.heard) {
    survey_->hear(odom_from_base, reading);
  }
  if (!has_map_) before_map_.insert(before_map_.end(), news.heard.begin(), news.heard.end());
}

void ExploreRun::count(const core::MapChange& change) {
  for (const core::MapEdit& edit : change.edits) {
    if (const auto* added = std::get_if<core::PlaceAdded>(&edit)) made_.insert(added->place.id);
    if (const auto* removed = std::get_if<core::PlaceRemoved>(&edit)) made_.erase(removed->id);
    if (std::holds_alternative<core::MapCleared>(edit)) made_.clear();
  }
}

core::Explorer::Moment ExploreRun::moment() const {
  return {map_from_odom_ * fix_->odom_from_base, way_,
          has_map_ && fix_->is_assumed ? kLostDoubt : doubt_};
}

void ExploreRun::arrived() {
  if (!spot() || ++at_ < task()->way.size()) return;
  explorer_->arrived(moment());
}

void ExploreRun::blocked(const std::string& why) {
  if (const auto spot = this->spot()) explorer_->blocked(moment(), *spot, why);
}

std::optional<core::Pose2d> ExploreRun::spot() const {
  if (!explorer_ || explorer_->isOver() || !explorer_->task()) return std::nullopt;
  return explorer_->task()->way.at(at_);
}

bool ExploreRun::isLost() const { return way_ - lost_from_ > kMostLostWay; }

bool ExploreRun::isHome() const {
  if (!fix_) return false;
  const core::Pose2d robot = map_from_odom_ * fix_->odom_from_base;
  return std::hypot(robot.x - home_.x, robot.y - home_.y) <= kAtHome;
}

std::vector<core::Explorer::Left> ExploreRun::left() const {
  return explorer_ ? explorer_->left() : std::vector<core::Explorer::Left>();
}

}  // namespace place_memory::node
