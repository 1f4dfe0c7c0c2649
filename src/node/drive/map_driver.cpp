#include "node/drive/map_driver.h"

#include <place_memory/MapEvent.h>
#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "core/sensing/moved_readings.h"
#include "node/base/ros_time.h"
#include "node/drive/map_driver_run.h"

namespace place_memory::node {
namespace {

using std::chrono::nanoseconds;

constexpr nanoseconds kLongestWait = std::chrono::milliseconds(50);
constexpr std::size_t kMostWaiting = 500000;  // moments
constexpr std::size_t kStandingScans = 64;    // that may still become places

// What an alignment leaves open of where the robot is.
constexpr double kAligned = 0.05;                         // [m]
constexpr double kAlignedTurn = 2.0 * core::kPi / 180.0;  // [rad]
constexpr double kTurnNoise = 2.0 * core::kPi / 180.0;    // by the root of the way [m]

std::array<double, 9> covarianceAfter(double untied_way, bool compass) {
  const double position = kAligned + core::positionSigma(untied_way, compass);
  const double turn = kAlignedTurn + kTurnNoise * std::sqrt(untied_way);
  std::array<double, 9> covariance{};
  covariance[0] = covariance[4] = position * position;
  covariance[8] = turn * turn;
  return covariance;
}

}  // namespace

MapDriver::MapDriver(const config::Parameters& parameters, core::PlaceMemory& memory,
                     Callbacks callbacks)
    : parameters_(parameters),
      memory_(memory),
      callbacks_(std::move(callbacks)),
      input_(parameters),
      correction_(parameters.drive.correct) {
  thread_ = std::thread([this] { work(); });
}

MapDriver::~MapDriver() {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    stopped_ = true;
  }
  input_.wake();
  thread_.join();
  try {
    if (run_) keep();
  } catch (const std::exception& error) {
    ROS_ERROR("The map of the drive is not kept: %s", error.what());
  }
}

void MapDriver::work() {
  for (;;) {
    DriveInput::Batch batch = input_.fetch(kLongestWait);
    {
      const std::lock_guard<std::mutex> lock(state_mutex_);
      if (stopped_) return;
    }
    try {
      take(std::move(batch));
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(5.0, "The drive: an error in the node was caught: %s", error.what());
    }
  }
}

void MapDriver::take(DriveInput::Batch batch) {
  const nanoseconds steady = steadyNow();
  std::vector<DriveMoment> ready;
  {
    const std::lock_guard<support::TurnMutex> lock(mutex_);
    if (!run_) return;
    if (batch.jumped) {
      run_->order.clear();
      run_->feed.restart();
      run_->to_mapper.restart();
      say(MapEvent::SESSION, "time ran backwards: where on the map the robot is is sought");
    }
    for (const auto& transform : batch.statics) run_->feed.addStatic(transform);
    if (batch.overrun > 0 || run_->order.waiting() > kMostWaiting) {
      say(MapEvent::TROUBLE, "readings come faster than they can be worked out, and are left out");
      batch.moments.clear();
    }
    for (DriveMoment& moment : batch.moments) run_->order.add(std::move(moment), steady);
    for (const auto& scan : batch.scans) addStanding(*scan);
    for (std::size_t i = 0; i < kRejects; ++i) {
      run_->losses.rejected[i] += batch.losses.rejected[i];
    }
    if (!batch.losses.problem.empty()) run_->losses.problem = batch.losses.problem;
    ready = run_->order.take(steady);
  }
  // Who asks for something has its turn between two moments.
  for (const DriveMoment& moment : ready) {
    const std::lock_guard<support::TurnMutex> lock(mutex_);
    if (!run_) return;
    run_->feed.take(moment);
  }
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (run_) keepIfDue();
}

void MapDriver::addStanding(const core::Scan& scan) {
  if (std::find(standing_.begin(), standing_.end(), scan.id) != standing_.end()) return;
  standing_.push_back(scan.id);
  if (standing_.size() > kStandingScans) standing_.erase(standing_.begin());
  run_->mapper.addStanding(scan.end, scan.odom_from_scan * scan.robot_in_scan,
                           core::movedReadings(scan.readings, scan.robot_in_scan.inverse()));
  if (run_->to_mapper.newest()) onStep(*run_->to_mapper.newest(), false);
}

void MapDriver::onStep(const OdometryMoment& now, bool jumped) {
  core::Mapper& mapper = run_->mapper;
  if (known_before_) mapper.setPose(*known_before_ * now.odom_from_base);
  known_before_.reset();
  const std::vector<core::ScanDecision> decisions = mapper.takeDecisions();
  const std::vector<core::MapperEvent> of_map = mapper.takeEvents();
  using Kind = core::ScanDecision::Kind;
  const bool is_new = std::any_of(decisions.begin(), decisions.end(), [](const auto& decision) {
    return decision.kind == Kind::kNewPlace;
  });
  if (!decisions.empty()) changed_ = true;
  if (is_new && mode() == config::Mode::kMap) {
    tryKeeping([&] { memory_.keepNewPlaces(mapper.map()); });
  }
  // Where a whole session moved, everybody hears of it at once.
  for (const core::MapperEvent& event : of_map) {
    if (event.kind == core::MapperEvent::Kind::kJoined) tryKeeping([this] { keep(); });
  }
  follow(decisions);
  if (jumped) {
    say(MapEvent::SESSION, "odometry started anew: where on the map the robot is is sought");
  }
  const std::optional<core::Pose2d> map_from_odom = mapper.mapFromOdom();
  Step step;
  step.now = now;
  step.covariance = covarianceAfter(mapper.untiedWay(), !parameters_.heading_topic.empty());
  if (!decisions.empty()) {
    step.belief = mapper.belief();
    step.scan_stamp = decisions.back().stamp;
  }
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    step.became_known = correction_.update(map_from_odom);
    step.map_from_odom = correction_.given();
    if (step.belief) belief_ = step.belief;
  }
  for (const DriveEvent& event : run_->events.update(now, decisions, of_map, map_from_odom)) {
    callbacks_.event(event);
  }
  callbacks_.step(step);
}

void MapDriver::follow(const std::vector<core::ScanDecision>& decisions) {
  if (!decisions.empty()) current_ = decisions.back().place;
  const core::Mapper& mapper = run_->mapper;
  core::DriveWhereabouts whereabouts;
  whereabouts.map_from_odom = mapper.sessionFromOdom();
  whereabouts.session = mapper.session();
  whereabouts.apart = mapper.session() != static_cast<int>(core::kFirstSession);
  if (whereabouts.map_from_odom) whereabouts.current = current_;
  memory_.followDrive(whereabouts);
}

bool MapDriver::setMode(config::Mode mode) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  const config::Mode before = this->mode();
  if (mode == before) return true;
  const core::MapperMode wanted =
      mode == config::Mode::kMap ? core::MapperMode::kMap : core::MapperMode::kLocalize;
  if (run_) keep();
  if (mode == config::Mode::kLocalize) {
    const bool has_places = run_ ? !run_->mapper.places().empty() : memory_.size() > 0;
    if (!has_places) return false;
  }
  if (mode == config::Mode::kOff) {
    end();
  } else if (run_) {
    run_->mapper.setMode(wanted);
  } else {
    begin(wanted);
    if (mode == config::Mode::kLocalize && run_->mapper.places().empty()) {
      end();
      return false;
    }
  }
  setModeTo(mode);
  return true;
}

void MapDriver::setModeTo(config::Mode mode) {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    mode_ = mode;
  }
  callbacks_.mode(mode);
}

void MapDriver::begin(core::MapperMode mode) {
  const auto label = [this](core::PlaceId id) {
    const auto place = memory_.place(id);
    return place ? place->label : "place " + std::to_string(id);
  };
  auto run = std::make_unique<Run>(
      parameters_, mode, label,
      [this](const OdometryMoment& now, bool jumped) { onStep(now, jumped); }, callbacks_.heard);
  const core::KeptMap kept = memory_.drivenMap();
  const core::Whereabouts known = memory_.whereabouts();
  known_before_.reset();
  if (!kept.nodes.empty()) {
    run->mapper.restore(kept);
    if (!known.apart) known_before_ = known.map_from_odom;
  }
  run_ = std::move(run);
  current_ = core::kNoPlace;
  changed_ = false;
  kept_ = steadyNow();
  standing_.clear();
  memory_.followDrive(core::DriveWhereabouts());
  input_.turn(true);
}

void MapDriver::end() {
  input_.turn(false);
  run_.reset();
  memory_.followDrive(std::nullopt);
  const std::lock_guard<std::mutex> lock(state_mutex_);
  correction_ = MapCorrection(parameters_.drive.correct);
  belief_.reset();
}

config::Mode MapDriver::mode() const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return mode_;
}

bool MapDriver::relocalize() {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (!run_) return false;
  run_->to_mapper.restart();
  {
    const std::lock_guard<std::mutex> state(state_mutex_);
    correction_.request();
  }
  follow({});
  say(MapEvent::SESSION, "it was asked where on the map the robot is: that is sought from nothing");
  return true;
}

bool MapDriver::setPose(const core::Pose2d& map_from_base) {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  if (!run_ || !run_->to_mapper.newest()) return false;
  run_->mapper.setPose(map_from_base);
  {
    const std::lock_guard<std::mutex> state(state_mutex_);
    correction_.request();
  }
  say(MapEvent::SESSION, "it was said where on the map the robot is");
  onStep(*run_->to_mapper.newest(), false);
  return true;
}

std::optional<core::Pose2d> MapDriver::mapFromOdom() const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return mode_ == config::Mode::kOff ? std::nullopt : correction_.given();
}

std::optional<core::BeliefSummary> MapDriver::belief() const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return belief_;
}

MapDriver::Health MapDriver::health() const {
  const std::lock_guard<support::TurnMutex> lock(mutex_);
  Health health;
  health.mode = mode();
  health.keep_problem = keep_problem_;
  if (!run_) return health;
  health.losses = run_->losses;
  health.waiting = run_->order.waiting();
  health.lost = run_->mapper.lost();
  return health;
}

void MapDriver::say(std::uint8_t kind, const std::string& sentence) const {
  callbacks_.event({kind, rosNow(), {}, sentence});
}

}  // namespace place_memory::node
