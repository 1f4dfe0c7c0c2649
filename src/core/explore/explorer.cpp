#include "core/explore/explorer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_memory::core {
namespace {

constexpr double kAtHome = 0.5;         // so near to where it began the robot is home [m]
constexpr double kSameTarget = 1.0;     // a frontier that moved no further is the same one [m]
constexpr double kBarrierAhead = 0.55;  // from the robot's middle to the middle of that [m]
// Times that it is tried whether a barrier is gone.
constexpr int kLiftedForMore = 1;
constexpr int kLiftedForHome = 6;
constexpr double kSureEvery = 1.0;   // [m]
constexpr double kSure = 0.7;        // share of the limit of doubt below which it is sure
constexpr double kLoopAge = 20.0;    // a spot is worth a loop that was left so much way ago [m]
constexpr double kLoopShare = 0.3;   // and that the way there is not longer than this share of it
constexpr double kLoopPause = 15.0;  // after a loop was sought none is for so much way [m]
constexpr double kNearby = 1.5;      // what is so near to its way the robot has been at [m]
constexpr double kCloser = 1.0;      // a wall tells more to who is nearer than that [m]
constexpr double kReach = 0.3;       // a spot is reached by a cell so near [m]

double between(const Pose2d& one, const Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

}  // namespace

void Explorer::remember(const Moment& now) {
  if (now.doubt > kSure * options_.doubt) return;
  if (!sure_.empty() && now.way - sure_.back().way < kSureEvery) return;
  sure_.push_back({now.robot, now.way});
}

// What is unknown beside the way once the robot is past it stays so.
void Explorer::lookAround(const Moment& now) {
  if (looks_ && between(*looks_, now.robot) < options_.past) return;
  if (looks_) looked_at_.push_back({looks_->x, looks_->y, options_.looked_around});
  looks_ = now.robot;
}

std::vector<MapDisc> Explorer::barred() const {
  std::vector<MapDisc> discs;
  for (const Barrier& barrier : barriers_) {
    if (barrier.disc.radius > 0.0) discs.push_back(barrier.disc);
  }
  return discs;
}

void Explorer::decide(const SurveyedCells& map, const Moment& now) {
  if (isOver()) return;
  remember(now);
  lookAround(now);
  if (options_.most_distance > 0.0 && now.way >= options_.most_distance && !returns_) {
    returns_ = true;
    at_home_ = Outcome::kBoundReached;
  }
  for (;;) {
    const FreeSpace space(options_.space, map, now.robot, barred());
    const GridWays ways(space, now.robot, options_.space.wide_berth);
    const std::vector<std::uint8_t> seen = inSight(space, map.trail, options_.sight);
    noteGround(space, map.trail, now);
    if (!returns_) {
      const std::vector<Frontier> frontiers =
          frontiersOf(space, options_.frontiers, looked_at_, seen);
      if (chooseLoop(space, ways, now) || chooseFrontier(space, ways, frontiers, now)) return;
      if (!returns_ && isWorthATry(map, now) && liftBarriers(kLiftedForMore)) continue;
      if (!returns_ && squeeze(map, now)) return;
      if (!returns_ && lookCloser(map, space, ways, now)) return;
    }
    listLeft(map, space, ways, now);
    if (goHome(space, ways, now) || !liftBarriers(kLiftedForHome)) break;
  }
  if (!task_ && !isOver()) outcome_ = Outcome::kBlocked;
}

void Explorer::noteGround(const FreeSpace& space, const std::vector<Pose2d>& trail,
                          const Moment& now) {
  if (returns_) return;
  const std::vector<std::uint8_t> seen = inSight(space, trail, {kNearby, 0.0});
  const auto cells = std::count(seen.begin(), seen.end(), std::uint8_t{1});
  ground_.note(now.way, static_cast<double>(cells) * space.resolution() * space.resolution());
}

void Explorer::take(Aim aim, const FreeSpace& space, const GridWays& ways, FreeSpace::Cell cell) {
  stood_at_home_ = false;
  looks_closer_ = false;
  task_ = Task{aim, space.centre(cell), ways.wayTo(cell), ways.length(cell)};
}

bool Explorer::chooseFrontier(const FreeSpace& space, const GridWays& ways,
                              const std::vector<Frontier>& frontiers, const Moment& now) {
  const Frontier* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  reachable_ = 0;
  for (const Frontier& frontier : frontiers) {
    if (!ways.reaches(frontier.cell)) continue;
    ++reachable_;
    double cost = ways.length(frontier.cell) - options_.gain * frontier.opens;
    const bool is_same = task_ && task_->aim == Aim::kFrontier &&
                         between(space.centre(frontier.cell), task_->target) < kSameTarget;
    if (is_same) cost -= options_.constancy;
    const bool is_beyond = options_.most_distance > 0.0 &&
                           now.way + ways.length(frontier.cell) > options_.most_distance;
    if (is_beyond || cost >= least) continue;
    least = cost;
    best = &frontier;
  }
  if (!best) {
    if (reachable_ > 0) at_home_ = Outcome::kBoundReached;
    return false;
  }
  // On its way to one that is far it keeps its patience.
  const bool goes_on = task_ && task_->aim == Aim::kFrontier &&
                       between(space.centre(best->cell), task_->target) < kSameTarget;
  if (!goes_on && ground_.isInVain(now.way)) {
    gave_up_at_ = now.way;
    returns_ = true;
    return false;
  }
  take(Aim::kFrontier, space, ways, best->cell);
  return true;
}

// The robot is told by its sonars where it does not fit; the map may show a door too narrow.
bool Explorer::squeeze(const SurveyedCells& map, const Moment& now) {
  const FreeSpace space(slim(), map, now.robot, barred());
  const GridWays ways(space, now.robot, options_.space.wide_berth);
  const std::vector<Frontier> frontiers =
      frontiersOf(space, options_.frontiers, looked_at_, inSight(space, map.trail, options_.sight));
  return chooseFrontier(space, ways, frontiers, now);
}

// A doorway that looks walled up from the middle of a room may not from near by.
bool Explorer::lookCloser(const SurveyedCells& map, const FreeSpace& space, const GridWays& ways,
                          const Moment& now) {
  const bool is_new = !task_ || !looks_closer_;
  if (is_new && closer_looks_ >= options_.closer_looks) return false;
  if (ground_.isInVain(now.way)) return false;
  const double most = options_.most_distance > 0.0 ? options_.most_distance - now.way
                                                   : std::numeric_limits<double>::infinity();
  const std::vector<std::uint8_t> near = inSight(space, map.trail, {kCloser, 0.0});
  std::optional<FreeSpace::Cell> best;
  for (FreeSpace::Cell cell = 0; cell < space.size(); ++cell) {
    if (near[cell] != 0 || !space.isPassable(cell) || !ways.reaches(cell)) continue;
    if (ways.length(cell) > most || (best && ways.length(cell) >= ways.length(*best))) continue;
    if (!isLookedAt(space.centre(cell))) best = cell;
  }
  if (!best) return false;
  if (is_new) ++closer_looks_;
  take(Aim::kFrontier, space, ways, *best);
  looks_closer_ = true;
  return true;
}

bool Explorer::isLookedAt(const Pose2d& spot) const {
  return std::any_of(looked_at_.begin(), looked_at_.end(), [&](const MapDisc& disc) {
    return between(spot, {disc.x, disc.y, 0.0}) < disc.radius;
  });
}

FreeSpaceOptions Explorer::slim() const {
  FreeSpaceOptions slim = options_.space;
  slim.radius = options_.squeeze * options_.space.radius;
  return slim;
}

bool Explorer::chooseLoop(const FreeSpace& space, const GridWays& ways, const Moment& now) {
  const bool is_sure = now.doubt <= options_.doubt;
  if (is_sure || now.way < no_loop_before_) return false;
  std::optional<FreeSpace::Cell> best;
  double least = std::numeric_limits<double>::infinity();
  for (const SureSpot& sure : sure_) {
    const double age = now.way - sure.way;
    if (age < kLoopAge) continue;
    const auto cell = ways.reachedNear(sure.spot.x, sure.spot.y, kReach);
    if (!cell || ways.length(*cell) > kLoopShare * age || ways.length(*cell) >= least) continue;
    least = ways.length(*cell);
    best = cell;
  }
  if (!best) return false;
  if (!task_ || task_->aim != Aim::kLoop) ++loops_sought_;
  take(Aim::kLoop, space, ways, *best);
  return true;
}

// Whether much is to be seen behind what bars the way.
bool Explorer::isWorthATry(const SurveyedCells& map, const Moment& now) const {
  if (barred().empty()) return false;
  const FreeSpace space(options_.space, map, now.robot, {});
  const GridWays ways(space, now.robot, options_.space.wide_berth);
  FrontierOptions large = options_.frontiers;
  large.least_opens = std::max(large.least_opens, options_.worth_a_try);
  const std::vector<Frontier> frontiers =
      frontiersOf(space, large, looked_at_, inSight(space, map.trail, options_.sight));
  return std::any_of(frontiers.begin(), frontiers.end(),
                     [&](const Frontier& frontier) { return ways.reaches(frontier.cell); });
}

bool Explorer::liftBarriers(int most) {
  bool lifted = false;
  std::vector<Barrier> left;
  for (Barrier& barrier : barriers_) {
    if (barrier.lifted < most && barrier.disc.radius > 0.0) {
      ++barrier.lifted;
      barrier.disc.radius = 0.0;
      lifted = true;
    }
    left.push_back(barrier);
  }
  barriers_ = std::move(left);
  return lifted;
}

bool Explorer::goHome(const FreeSpace& space, const GridWays& ways, const Moment& now) {
  is_home_ = between(now.robot, home_) <= kAtHome || stood_at_home_;
  task_.reset();
  if (is_home_ || options_.stay) {
    outcome_ = at_home_;
    return true;
  }
  const auto cell = ways.reachedNear(home_.x, home_.y, kAtHome);
  if (cell) take(Aim::kHome, space, ways, *cell);
  return cell.has_value();
}

void Explorer::arrived(const Moment& now) {
  if (!task_) return;
  if (task_->aim == Aim::kFrontier)
    looked_at_.push_back({task_->target.x, task_->target.y, options_.looked_around});
  if (task_->aim == Aim::kLoop) no_loop_before_ = now.way + kLoopPause;
  stood_at_home_ = task_->aim == Aim::kHome;
  task_.reset();
}

void Explorer::blocked(const Moment& now, const Pose2d& spot, const std::string& why) {
  const double distance = between(now.robot, spot);
  const double ahead = std::min(kBarrierAhead, std::max(distance, 1e-3));
  const double share = ahead / std::max(distance, 1e-3);
  const Pose2d at{now.robot.x + share * (spot.x - now.robot.x),
                  now.robot.y + share * (spot.y - now.robot.y), 0.0};
  if (task_ && task_->aim == Aim::kLoop) no_loop_before_ = now.way + kLoopPause;
  const bool was_there = task_ && task_->aim == Aim::kFrontier &&
                         between(now.robot, task_->target) <= options_.near_target;
  if (was_there) return arrived(now);
  task_.reset();
  for (Barrier& barrier : barriers_) {
    const bool is_same = between({barrier.disc.x, barrier.disc.y, 0.0}, at) <= options_.barrier;
    if (!is_same || barrier.disc.radius > 0.0) continue;
    barrier.disc.radius = options_.barrier;
    barrier.why = why;
    return;
  }
  barriers_.push_back({{at.x, at.y, options_.barrier}, why, 0});
}

std::string Explorer::whyLeft(const Pose2d& spot, const GridWays& anyhow,
                              FreeSpace::Cell cell) const {
  const Barrier* nearest = nullptr;
  for (const Barrier& barrier : barriers_) {
    if (barrier.disc.radius <= 0.0) continue;
    const Pose2d at{barrier.disc.x, barrier.disc.y, 0.0};
    if (!nearest || between(at, spot) < between({nearest->disc.x, nearest->disc.y, 0.0}, spot)) {
      nearest = &barrier;
    }
  }
  if (anyhow.reaches(cell) && nearest) return nearest->why;
  return "what leads there is too narrow for the robot";
}

void Explorer::listLeft(const SurveyedCells& map, const FreeSpace& space, const GridWays& ways,
                        const Moment& now) {
  left_.clear();
  const std::vector<std::uint8_t> seen = inSight(space, map.trail, options_.sight);
  if (at_home_ == Outcome::kBoundReached || gave_up_at_) {
    const std::string why =
        gave_up_at_ ? "for " + std::to_string(std::lround(*gave_up_at_ - ground_.grewAt())) +
                          " m other openings had led to no new ground"
                    : "the distance that was allowed is driven";
    for (const Frontier& frontier : frontiersOf(space, options_.frontiers, looked_at_, seen)) {
      if (ways.reaches(frontier.cell)) left_.push_back({space.centre(frontier.cell), why});
    }
  }
  const FreeSpace without(options_.space, map, now.robot, {});
  const GridWays anyhow(without, now.robot, options_.space.wide_berth);
  const FreeSpace for_slim(slim(), map, now.robot, {});
  const GridWays of_slim(for_slim, now.robot, options_.space.wide_berth);
  for (const Frontier& frontier : frontiersOf(without, options_.frontiers, looked_at_, seen)) {
    if (ways.reaches(frontier.cell) || !of_slim.reaches(frontier.cell)) continue;
    const Pose2d spot = without.centre(frontier.cell);
    left_.push_back({spot, whyLeft(spot, anyhow, frontier.cell)});
  }
}

}  // namespace place_memory::core
