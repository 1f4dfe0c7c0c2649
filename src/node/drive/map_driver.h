#ifndef PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_H
#define PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_H

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "config/parameters.h"
#include "core/mapping/mapper.h"
#include "node/drive/drive_events.h"
#include "node/drive/drive_input.h"
#include "node/drive/map_correction.h"
#include "node/drive/mapper_feed.h"
#include "place_memory/core/place_memory.h"
#include "support/turn_mutex.h"

namespace place_memory::node {

/// Drives the map along with the robot: feeds a mapper in the order of stamps with what the robot
/// senses, and has the memory follow what it makes of that.
///
/// Works on a thread of its own; what is asked for waits for a scan that is being worked out, some
/// milliseconds, and sometimes for the disk. Thread-safe.
class MapDriver {
 public:
  /// What came of the drive up to a pose of odometry.
  struct Step {
    OdometryMoment now;
    /// Odometry's frame in the map as others are given it; nothing: none is.
    std::optional<core::Pose2d> map_from_odom;
    bool became_known = false;         ///< with this step; or anew
    std::array<double, 9> covariance;  ///< of the robot in the map: row-major over x, y, yaw
    std::chrono::nanoseconds scan_stamp{0};
    std::optional<core::BeliefSummary> belief;  ///< after a scan
  };

  struct Health {
    config::Mode mode = config::Mode::kOff;
    DriveLosses losses;
    std::string keep_problem;  ///< why the map cannot be kept; empty: it can
    std::size_t waiting = 0;   ///< messages for others of their time
    double lost = 1.0;         ///< probability
  };

  /// Called on the driver's thread, or on that of who asks for something.
  struct Callbacks {
    std::function<void(const Step&)> step;
    std::function<void(const DriveEvent&)> event;
    std::function<void(config::Mode)> mode;  ///< it is this one from now on
    MapperFeed::Heard heard;                 ///< may be null
  };

  /// All must outlive it. The mode is off at first.
  MapDriver(const config::Parameters& parameters, core::PlaceMemory& memory, Callbacks callbacks);
  /// Keeps the map.
  ~MapDriver();
  MapDriver(const MapDriver&) = delete;
  MapDriver& operator=(const MapDriver&) = delete;

  DriveInput& input() { return input_; }

  /// False where there is no place to localize by; the mode is then as it was. Throws
  /// PlaceMemoryError where the map cannot be kept or read, and std::invalid_argument where what is
  /// kept of it cannot be used.
  bool setMode(config::Mode mode);
  config::Mode mode() const;

  /// False: the mode is off.
  bool relocalize();
  /// A person, or another program, says where the robot is now. False: the mode is off, or odometry
  /// has not been heard yet.
  bool setPose(const core::Pose2d& map_from_base);

  /// Where scans that agree say that the robot is, too few of them yet; none while the mode is off.
  std::vector<core::ClosureQuestion> closureQuestions() const;
  /// A person says that the robot is there, or is not. Nothing: the mode is off.
  std::optional<core::ClosureWord> judgeClosure(core::PlaceId place, bool confirm);

  /// The transform map_frame -> odom_frame; nothing while it is not known, or the mode is off.
  std::optional<core::Pose2d> mapFromOdom() const;
  /// After the newest scan; nothing: there was none, or the mode is off.
  std::optional<core::BeliefSummary> belief() const;
  Health health() const;

  /// As PlaceMemory has them; the drive's map follows at once.
  core::PlaceMemory::Learned learn(const core::Scan& scan, const std::string& label, bool force);
  void rename(const std::string& label, const std::string& new_label);
  void remove(const std::string& label);
  std::size_t clear();
  /// `work` changes the memory's map otherwise, as where another one is loaded: what the drive has
  /// made is kept before, and the drive goes on with what the map is then. What `work` throws
  /// passes through.
  void change(const std::function<void()>& work);

 private:
  struct Run;

  void work();
  void take(DriveInput::Batch batch);
  void addStanding(const core::Scan& scan);
  void onStep(const OdometryMoment& now, bool jumped);
  void follow(const std::vector<core::ScanDecision>& decisions);
  void begin(core::MapperMode mode);
  /// In the same mode, or off where there is nothing left to localize by.
  void beginAnew();
  void end();
  void setModeTo(config::Mode mode);
  /// What the drive has made of the map, or in mode localize what its links learn. Throws
  /// PlaceMemoryError in mode map.
  void keep();
  /// What it throws becomes an event.
  void tryKeeping(const std::function<void()>& keeping);
  void keepIfDue();
  void say(std::uint8_t kind, const std::string& sentence) const;

  const config::Parameters& parameters_;
  core::PlaceMemory& memory_;
  const Callbacks callbacks_;
  DriveInput input_;

  // Guards the next ones; who holds it may take the state's, not the reverse. The driver's thread,
  // which takes it all the time where messages come faster than they are worked out, lets others
  // in.
  mutable support::TurnMutex mutex_;
  std::unique_ptr<Run> run_;  // nullptr: off
  /// Odometry's frame in the map, as it was known before the drive began.
  std::optional<core::Pose2d> known_before_;
  core::PlaceId current_ = core::kNoPlace;
  bool changed_ = false;              // since the map was kept
  std::chrono::nanoseconds kept_{0};  // steady
  std::string keep_problem_;  // why it could not be kept when it was tried last; empty: it could
  std::vector<std::uint64_t> standing_;  // scans that are nodes

  mutable std::mutex state_mutex_;  // guards the next ones
  config::Mode mode_ = config::Mode::kOff;
  MapCorrection correction_;
  std::optional<core::BeliefSummary> belief_;
  bool stopped_ = false;

  std::thread thread_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_MAP_DRIVER_H
