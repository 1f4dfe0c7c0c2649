#include "node/place_memory_node.h"

#include <nav_msgs/OccupancyGrid.h>
#include <ros/console.h>
#include <ros/names.h>
#include <ros/network.h>
#include <visualization_msgs/Marker.h>

#include <cmath>
#include <utility>

#include "config/memory_options.h"
#include "core/store/store_file.h"
#include "node/answer/answer_words.h"
#include "node/base/cell_marker.h"
#include "node/base/conversions.h"
#include "node/base/ros_time.h"
#include "node/drive/closure_words.h"
#include "node/drive/drive_diagnostics.h"
#include "node/input/sensor_placement.h"
#include "node/map/memory_diagnostics.h"
#include "node/names/node_names.h"
#include "node/scan/input_diagnostics.h"

namespace place_memory::node {
namespace {

const ros::WallDuration kDiagnosticsPeriod(1.0);
const ros::WallDuration kAtOnce(0.001);
constexpr int kTicksBetweenWarnings = 10;
constexpr double kScanLevel = 0.025;   // of its cells in rviz, above those of a recalled place [m]
constexpr double kWorthARoute = 0.02;  // probability of a place
constexpr std::chrono::nanoseconds kPosePeriod = std::chrono::milliseconds(100);

ros::NodeHandle withQueue(const ros::NodeHandle& names, ros::CallbackQueueInterface& queue) {
  ros::NodeHandle with_queue(names);
  with_queue.setCallbackQueue(&queue);
  return with_queue;
}

/// By which robots are told apart on /diagnostics: the namespace of the node, where it has one, or
/// the machine.
std::string robotName(const std::string& node_name) {
  const std::string names = ros::names::parentNamespace(node_name);
  return names.empty() || names == "/" ? ros::network::getHost() : names.substr(1);
}

}  // namespace

PlaceMemoryNode::PlaceMemoryNode(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                                 const config::Parameters& parameters)
    : names_(withQueue(names, queue_)),
      private_names_(private_names),
      parameters_(parameters),
      memory_(openMemory()),
      scans_(parameters_.scan.max_age),
      examiner_(parameters_.sonar, [this](core::PlaceId id) { return memory_->grid(id); }),
      scan_grid_(private_names_.advertise<nav_msgs::OccupancyGrid>(kScanGridTopic, 1, true)),
      scan_cells_(private_names_.advertise<visualization_msgs::Marker>(kScanCellsTopic, 1, true)),
      answer_publisher_(private_names_, *memory_, parameters_),
      drive_publisher_(names_, private_names_, *memory_, parameters_),
      map_publisher_(private_names_, *memory_, parameters_, [this] { return locateRobot(); }),
      fused_map_publisher_(private_names_, *memory_, parameters_),
      driver_(parameters_, *memory_, driveCallbacks()),
      transforms_(names_, buffer_,
                  [this](const geometry_msgs::TransformStamped& transform, bool is_static) {
                    driver_.input().take(transform, is_static);
                  }),
      map_frame_broadcaster_(
          names_, [this] { return mapFromOdom(); }, parameters_),
      drive_lease_(names_),
      echoes_(buffer_, parameters_.base_frame),
      robot_finder_(parameters_, buffer_, *memory_, driver_),
      go_server_(names_, private_names_,
                 {*memory_, driver_, {parameters_, drive_lease_, echoes_, robot_finder_}}),
      explore_server_(
          names_, private_names_,
          {*memory_, driver_, survey_feed_, {parameters_, drive_lease_, echoes_, robot_finder_}}),
      scan_server_(names_, private_names_, parameters_, drive_lease_, buffer_, transforms_,
                   scanCallbacks()),
      live_parameters_(withQueue(private_names_, queue_), parameters_,
                       [this](const config::Parameters& now) {
                         memory_->setOptions(now.match.recognizer, now.places);
                         scan_server_.setNoEcho(now.no_echo);
                       }),
      diagnostics_(names_, private_names_),
      clicks_(
          private_names_, *memory_, answer_publisher_, [this] { return believedPlaces(); },
          [this](core::PlaceId id, bool is_there) { judgeClosure(id, is_there); }, parameters_),
      handles_(private_names_, *memory_, static_cast<std::size_t>(parameters_.markers.clickable),
               parameters_.map_frame,
               [this](core::PlaceId id, PlaceEntry entry) { clicks_.choose(id, entry); }),
      drive_services_(names_, private_names_, driver_, *memory_, parameters_),
      services_(private_names_, {*memory_, answer_publisher_, scans_, examiner_, driver_,
                                 drive_publisher_, parameters_, store_problem_}),
      route_services_(
          private_names_, *memory_, [this] { return believedPlaces(); }, parameters_),
      store_services_(private_names_, *memory_, driver_, answer_publisher_, parameters_) {
  memory_->listen([this](const core::MapChange& change) { survey_feed_.follow(change); });
  setUpDiagnostics();
  sayWhatIsKnown();
  drive_publisher_.publish(config::Mode::kOff);
  drive_services_.begin();
}

void PlaceMemoryNode::setUpDiagnostics() {
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  diagnostics_.setHardwareID(robotName(private_names_.getNamespace()));
  diagnostics_.add("memory", [this](Status& status) {
    diagnoseMemory(memory_->size(), memory_->storeHealth(), parameters_.store, store_problem_,
                   status);
  });
  diagnostics_.add("building map",
                   [this](Status& status) { fused_map_publisher_.diagnose(status); });
  diagnostics_.add("sensors",
                   [this](Status& status) { diagnoseSonars(scan_server_.health(), status); });
  diagnostics_.add("sensor doctor", [this](Status& status) {
    examiner_.diagnose(scan_server_.health().sensors, buffer_, parameters_.base_frame, status);
  });
  diagnostics_.add("compass",
                   [this](Status& status) { diagnoseCompass(scan_server_.health(), status); });
  diagnostics_.add("transforms", [this](Status& status) {
    diagnoseTransforms(buffer_, transforms_.leftOut(), scan_server_.health(), parameters_, rosNow(),
                       status);
  });
  diagnostics_.add("drive", [this](Status& status) { diagnoseDrive(driver_.health(), status); });
  // Forced, because the updater's own pace is that of simulated time, which may stand still.
  diagnostics_timer_ = names_.createSteadyTimer(
      kDiagnosticsPeriod, [this](const ros::SteadyTimerEvent&) { onDiagnosticsTimer(); });
  // On the thread of the other one, because the updater may be asked by one at a time.
  health_timer_ = names_.createSteadyTimer(
      kAtOnce, [this](const ros::SteadyTimerEvent&) { diagnostics_.force_update(); }, true, false);
  memory_->watchStore(
      [this, was_ok = memory_->storeHealth().ok](const core::StoreHealth& health) mutable {
        if (!health.ok) ROS_ERROR("The map cannot be changed: %s", health.problem.c_str());
        if (health.ok && !was_ok) ROS_INFO("The map can be changed again");
        was_ok = health.ok;
        health_timer_.stop();
        health_timer_.start();
      });
}

void PlaceMemoryNode::sayWhatIsKnown() const {
  const bool is_kept = !parameters_.store.empty() && store_problem_.empty();
  ROS_INFO("%s known, kept in %s", placesInWords(memory_->size()).c_str(),
           is_kept ? core::storePath(parameters_.store).c_str() : "memory only");
  const core::StoreHealth health = memory_->storeHealth();
  if (!health.ok) ROS_ERROR("The map cannot be changed: %s", health.problem.c_str());
  for (const std::string& sentence : health.set_aside) ROS_WARN("Left out: %s", sentence.c_str());
}

void PlaceMemoryNode::onDiagnosticsTimer() {
  diagnostics_.force_update();
  map_publisher_.follow();
  if (parameters_.markers.clickable > 0) handles_.follow(locateRobot(), askedPlaces());
  if (ros::Time::isValid()) return;
  if (ticks_without_time_++ % kTicksBetweenWarnings == 0) {
    ROS_WARN("Waiting for simulated time on /clock");  // throttled logging needs a time itself
  }
}

void PlaceMemoryNode::stop() {
  explore_server_.stop();
  go_server_.stop();
  scan_server_.stop();
}

std::unique_ptr<core::PlaceMemory> PlaceMemoryNode::openMemory() {
  core::PlaceMemoryOptions options = config::memoryOptions(parameters_);
  options.opening.progress = [](const std::string& sentence) { ROS_INFO("%s", sentence.c_str()); };
  options.clock = rosNow;
  try {
    return std::make_unique<core::PlaceMemory>(options);
  } catch (const core::StoreError& error) {
    store_problem_ = error.what();
    ROS_ERROR("Places are kept in memory only: %s", error.what());
  }
  options.store_path.clear();
  return std::make_unique<core::PlaceMemory>(options);
}

ScanServer::Callbacks PlaceMemoryNode::scanCallbacks() {
  ScanServer::Callbacks callbacks;
  callbacks.finished = [this](std::shared_ptr<const core::Scan> scan) {
    publishScan(*scan);
    driver_.input().take(scan);
    scans_.add(std::move(scan));
  };
  callbacks.partial = [this](const core::Scan& scan) { publishScan(scan); };
  callbacks.under_way = [this](bool under_way) { scans_.setUnderWay(under_way); };
  callbacks.time_jump = [this] {
    dropScans();
    go_server_.onTimeJump();
    explore_server_.onTimeJump();
  };
  callbacks.taken = [this](const Taken& taken) {
    driver_.input().take(taken);
    echoes_.take(taken);
  };
  return callbacks;
}

MapDriver::Callbacks PlaceMemoryNode::driveCallbacks() {
  MapDriver::Callbacks callbacks;
  callbacks.step = [this](const MapDriver::Step& step) { publishStep(step); };
  callbacks.heard = [this](const core::Pose2d& odom_from_base, const core::SonarReading& reading) {
    survey_feed_.hear(odom_from_base, reading);
  };
  callbacks.event = [this](const DriveEvent& event) { drive_publisher_.publish(event); };
  callbacks.mode = [this](config::Mode mode) {
    drive_publisher_.publish(mode);
    answer_publisher_.publishCurrentPlace();
  };
  return callbacks;
}

// By one thread at a time: the driver holds a mutex.
void PlaceMemoryNode::publishStep(const MapDriver::Step& step) {
  survey_feed_.setDoubt(std::sqrt(step.covariance[0]));
  drive_publisher_.publish(step);
  if (step.belief) answer_publisher_.publishCurrentPlace();
  const std::chrono::nanoseconds since = step.now.stamp - published_pose_;
  if (!step.belief && !step.became_known && since.count() >= 0 && since < kPosePeriod) return;
  const auto pose = drive_publisher_.poseOf(step);
  if (!pose) return;
  published_pose_ = step.now.stamp;
  answer_publisher_.publishPose(*pose);
}

std::vector<core::RouteStart> PlaceMemoryNode::believedPlaces() const {
  std::vector<core::RouteStart> places;
  const std::optional<core::BeliefSummary> belief = driver_.belief();
  if (!belief) return places;
  for (const auto& [id, probability] : belief->places) {
    if (probability >= kWorthARoute) places.push_back({id, probability});
  }
  return places;
}

std::set<core::PlaceId> PlaceMemoryNode::askedPlaces() const {
  std::set<core::PlaceId> places;
  for (const core::ClosureQuestion& question : driver_.closureQuestions()) {
    places.insert(question.place);
  }
  return places;
}

void PlaceMemoryNode::judgeClosure(core::PlaceId id, bool is_there) {
  const auto word = driver_.judgeClosure(id, is_there);
  if (word) ROS_INFO("%s", replyTo(*word, is_there).message.c_str());
}

std::optional<core::Pose2d> PlaceMemoryNode::mapFromOdom() const {
  if (driver_.mode() != config::Mode::kOff) return driver_.mapFromOdom();
  const core::Whereabouts whereabouts = memory_->whereabouts();
  return whereabouts.apart ? std::nullopt : whereabouts.map_from_odom;
}

void PlaceMemoryNode::publishScan(const core::Scan& scan) {
  const std_msgs::Header header = makeHeader(scanFrame(parameters_), toRosTime(scan.end));
  scan_grid_.publish(
      toOccupancyGrid(scan.grid, scan.odom_from_scan, header, parameters_.sonar.prior));
  scan_cells_.publish(toCellMarker(scan.grid, scan.odom_from_scan, header, kScanColor, kScanLevel));
}

void PlaceMemoryNode::dropScans() {
  scans_.drop();
  memory_->forgetWhereabouts();
  answer_publisher_.overtake();
  ROS_WARN("The newest scan is dropped, and the next place will be linked to none");
}

std::optional<core::Pose2d> PlaceMemoryNode::locateRobot() const {
  const core::Whereabouts whereabouts = memory_->whereabouts();
  std::chrono::nanoseconds stamp{0};
  if (!parameters_.odom_frame.empty() && whereabouts.map_from_odom) {
    const auto base = lookupNewest(buffer_, parameters_.odom_frame, parameters_.base_frame, stamp);
    if (base) return *whereabouts.map_from_odom * base->pose;
  }
  const std::optional<core::Place> place = memory_->place(whereabouts.previous);
  return place ? std::optional<core::Pose2d>(place->map_from_place) : std::nullopt;
}

}  // namespace place_memory::node
