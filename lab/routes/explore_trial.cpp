#include "routes/explore_trial.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/drive/leg_driver.h"
#include "core/explore/surveyed_map.h"
#include "core/mapping/mapper.h"
#include "mapping/mapping_run.h"
#include "routes/true_floor.h"

namespace place_memory::routes {
namespace {

using core::Explorer;
using core::Pose2d;
using std::chrono::nanoseconds;

constexpr double kStart = 1000.0;     // stamp of the drive's time 0 [s]
constexpr double kMapCell = 0.1;      // of the map that is explored by [m]
constexpr double kDecideEvery = 0.5;  // of the way [m]
constexpr double kHome = 1.0;         // [m]
constexpr double kReach = 4.572;      // of the sonars [m]
constexpr double kLostDoubt = 3.0;    // [m]
constexpr double kLostTime = 900.0;   // [s]
constexpr double kSameTarget = 1.0;   // a target that moved no further is the same one [m]

double between(const Pose2d& one, const Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

/// A robot with a mapper and an explorer.
class Robot {
 public:
  Robot(const sim::World& world, const ExploreRecipe& recipe, std::uint64_t seed)
      : recipe_(recipe),
        options_(mapping::mapperOptions()),
        simulator_(world, {}, recipe.drive, seed),
        mapper_(options_),
        recorder_(mapper_, truth_, recipe.compass, kStart),
        map_({kMapCell}, core::GridGeometry{options_.cell_size}, options_.sonar),
        begin_(simulator_.base()) {}

  ExploreResult run() {
    drive(0.0, 0.0);
    begin();
    while (!explorer_->isOver() && time() < recipe_.most_time && !is_lost_) step();
    return result();
  }

 private:
  double time() const { return newest_.t; }
  nanoseconds now() const { return recorder_.stampOf(newest_); }
  Pose2d pose() const { return map_from_odom_ * newest_.odom; }

  void begin() {
    explorer_.emplace(recipe_.explorer, pose());
    decide();
  }

  void drive(double forward, double turn) {
    trials::DriveSimulator::Step step = simulator_.step(forward, turn);
    // Wheels that push against something turn it away.
    if (step.is_blocked) step = simulator_.step(0.0, turn);
    newest_ = std::move(step.moment);
    way_ += std::abs(step.forward);
    recorder_.feed(newest_);
    const auto& ring = sim::SimulatedRobot{}.ring;
    for (const core::SonarReading& reading : newest_.readings) {
      map_.hear(newest_.odom, reading);
      const double bearing = core::wrapAngle(reading.sensor_pose.yaw);
      const auto sensor = static_cast<core::SensorId>(
          std::lround((bearing < 0.0 ? bearing + 2.0 * core::kPi : bearing) / ring.spacing));
      echoes_.hear(sensor, now(), reading.sensor_pose, reading.range);
    }
    way_in_truth_.push_back(simulator_.base());
    ticks_.push_back({tasks_, aim_, way_});
    follow();
  }

  /// Where the mapper has the robot now.
  void follow() {
    const std::optional<Pose2d> map_from_odom = mapper_.mapFromOdom();
    if (map_from_odom) {
      lost_since_.reset();
      // Before there is a map the robot goes by odometry.
      if (!is_known_ && explorer_) {
        const Pose2d home = *map_from_odom * map_from_odom_.inverse() * home_;
        map_from_odom_ = *map_from_odom;
        is_known_ = true;
        explorer_.emplace(recipe_.explorer, home);
        home_ = home;
        decide();
      }
      map_from_odom_ = *map_from_odom;
    } else if (is_known_) {
      if (!lost_since_) lost_since_ = time();
      is_lost_ = time() - *lost_since_ > kLostTime;
    }
    if (!explorer_) home_ = pose();
  }

  void layPlaces() {
    std::set<core::PlaceId> there;
    for (const core::ScanNode& node : mapper_.graph().nodes()) {
      if (node.place == core::kNoPlace || node.session != 1) continue;
      there.insert(node.place);
      core::Place place;
      place.id = node.place;
      place.map_from_place = node.pose;
      std::shared_ptr<const core::EvidenceGrid>& grid = grids_[node.place];
      if (!grid) {
        grid = std::make_shared<const core::EvidenceGrid>(
            core::SonarModel(options_.sonar)
                .build(*node.readings, core::GridGeometry{options_.cell_size}));
      }
      map_.add(place, grid);
    }
    for (auto it = grids_.begin(); it != grids_.end();) {
      if (there.count(it->first) > 0) {
        ++it;
        continue;
      }
      map_.apply({0, nanoseconds(0), {core::PlaceRemoved{it->first}}});
      it = grids_.erase(it);
    }
  }

  Explorer::Moment moment() const {
    const double doubt =
        lost_since_ ? kLostDoubt : core::positionSigma(mapper_.untiedWay(), recipe_.compass);
    return {pose(), way_, doubt};
  }

  void decide() {
    const std::clock_t begin = std::clock();
    layPlaces();
    const std::optional<Explorer::Task> before = explorer_->task();
    explorer_->decide(map_.cells(map_from_odom_), moment());
    countTask(before);
    const double cost = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    cost_ += cost;
    longest_ = std::max(longest_, cost);
    ++decisions_;
    decided_at_ = way_;
    at_ = 0;
    leg_.reset();
  }

  void countTask(const std::optional<Explorer::Task>& before) {
    const std::optional<Explorer::Task>& task = explorer_->task();
    if (!task) return;
    const bool is_same =
        before && before->aim == task->aim && between(before->target, task->target) < kSameTarget;
    if (!is_same) ++tasks_;
    aim_ = task->aim;
  }

  void step() {
    if (!leg_) {
      core::LegDriverOptions options;
      options.speed = recipe_.drive.speed;
      options.radius = recipe_.radius;
      options.clearance = recipe_.clearance;
      leg_.emplace(options, explorer_->task()->way[at_]);
    }
    const core::Velocity velocity = leg_->update(now(), pose(), echoes_);
    drive(velocity.forward * recipe_.drive.tick, velocity.turn * recipe_.drive.tick);
    if (!leg_ || explorer_->isOver()) return;  // it was decided anew
    using State = core::LegDriver::State;
    if (leg_->state() == State::kArrived) {
      leg_.reset();
      if (++at_ < explorer_->task()->way.size()) return;
      explorer_->arrived(moment());
      decide();
    } else if (leg_->isOver()) {
      ++blocked_;
      explorer_->blocked(moment(), explorer_->task()->way[at_], leg_->why());
      decide();
    } else if (way_ - decided_at_ >= kDecideEvery) {
      decide();
    }
  }

  ExploreResult result() {
    ExploreResult result;
    result.is_done = explorer_->outcome() == Explorer::Outcome::kDone;
    result.is_home = between(simulator_.base(), begin_) <= kHome;
    result.ended = is_lost_                                               ? "lost"
                   : explorer_->outcome() == Explorer::Outcome::kUnderWay ? "time is over"
                   : explorer_->outcome() == Explorer::Outcome::kBlocked  ? "blocked"
                   : explorer_->outcome() == Explorer::Outcome::kDone     ? "done"
                                                                          : "bound reached";
    const TrueFloor floor(simulator_.scene(), begin_, trials::DriveSimulator::kBaseRadius, kReach);
    result.way = way_;
    const std::vector<double> seen = floor.seenShares(way_in_truth_);
    result.seen = seen.back();
    result.account = accountOf(ticks_, seen, floor.area());
    const TrueFloor::Tour tour = floor.tour(result.seen);
    result.tour = tour.length;
    result.viewpoints = tour.viewpoints;
    result.time = time();
    result.blocked = blocked_;
    result.loops = explorer_->loopsSought();
    result.decision = cost_ / std::max(decisions_, 1);
    result.longest_decision = longest_;
    result.map = mapping::figures(mapper_, recorder_.run(), truth_);
    result.left = explorer_->left();
    result.kept = mapper_.map();
    result.way_in_truth = way_in_truth_;
    return result;
  }

  const ExploreRecipe recipe_;
  const core::MapperOptions options_;
  trials::DriveSimulator simulator_;
  core::Mapper mapper_;
  mapping::Truth truth_;
  mapping::MappingRecorder recorder_;
  core::SurveyedMap map_;
  std::map<core::PlaceId, std::shared_ptr<const core::EvidenceGrid>> grids_;
  core::EchoRing echoes_{std::chrono::milliseconds(600)};
  std::optional<Explorer> explorer_;
  std::optional<core::LegDriver> leg_;
  std::size_t at_ = 0;  ///< of the task's way
  trials::DriveMoment newest_;
  const Pose2d begin_;
  Pose2d map_from_odom_;
  Pose2d home_;
  bool is_known_ = false;
  bool is_lost_ = false;
  std::optional<double> lost_since_;
  double way_ = 0.0;
  double decided_at_ = 0.0;
  std::size_t blocked_ = 0;
  double cost_ = 0.0, longest_ = 0.0;
  int decisions_ = 0;
  std::size_t tasks_ = 0;
  Explorer::Aim aim_ = Explorer::Aim::kFrontier;
  std::vector<Pose2d> way_in_truth_;
  std::vector<TickOfTask> ticks_;  ///< of each of these
};

}  // namespace

ExploreResult explore(const sim::World& world, const ExploreRecipe& recipe, std::uint64_t seed) {
  return Robot(world, recipe, seed).run();
}

}  // namespace place_memory::routes
