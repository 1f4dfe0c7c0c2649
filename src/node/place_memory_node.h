#ifndef PLACE_MEMORY_NODE_PLACE_MEMORY_NODE_H
#define PLACE_MEMORY_NODE_PLACE_MEMORY_NODE_H

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/wall_timer.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/answer/answer_publisher.h"
#include "node/answer/kept_scans.h"
#include "node/answer/place_clicks.h"
#include "node/answer/place_services.h"
#include "node/answer/route_services.h"
#include "node/answer/store_services.h"
#include "node/base/drive_lease.h"
#include "node/base/guarded_queue.h"
#include "node/drive/drive_publisher.h"
#include "node/drive/drive_services.h"
#include "node/drive/map_driver.h"
#include "node/go/echo_listener.h"
#include "node/go/explore_server.h"
#include "node/go/go_server.h"
#include "node/go/robot_finder.h"
#include "node/go/survey_feed.h"
#include "node/input/transform_input.h"
#include "node/live_parameters.h"
#include "node/map/fused_map_publisher.h"
#include "node/map/map_frame_broadcaster.h"
#include "node/map/map_publisher.h"
#include "node/map/place_handles.h"
#include "node/scan/scan_server.h"
#include "node/scan/sensor_examiner.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The node: scans go from the action to the services and topics.
class PlaceMemoryNode {
 public:
  /// A store that cannot be used is reported, and the places are kept in memory. Throws
  /// std::invalid_argument naming a parameter out of range.
  PlaceMemoryNode(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                  const config::Parameters& parameters);

  /// Handles what is to be done on the caller's thread, and waits so long for it.
  void spinOnce(const ros::WallDuration& wait) { queue_.callAvailable(wait); }

  /// Ends a scan or a goal that runs and stops the robot. To be called before ros::shutdown().
  void stop();

 private:
  std::unique_ptr<core::PlaceMemory> openMemory();
  ScanServer::Callbacks scanCallbacks();
  MapDriver::Callbacks driveCallbacks();
  void publishScan(const core::Scan& scan);
  void dropScans();
  std::optional<core::Pose2d> locateRobot() const;
  std::optional<core::Pose2d> mapFromOdom() const;
  std::vector<core::RouteStart> believedPlaces() const;
  /// Of which a person may say whether the robot is there.
  std::set<core::PlaceId> askedPlaces() const;
  void judgeClosure(core::PlaceId id, bool is_there);
  void publishStep(const MapDriver::Step& step);
  void setUpDiagnostics();
  void onDiagnosticsTimer();
  void sayWhatIsKnown() const;

  GuardedQueue queue_{"diagnostics"};
  ros::NodeHandle names_;
  ros::NodeHandle private_names_;
  const config::Parameters parameters_;

  std::string store_problem_;  ///< why the store is not used; empty: it is, or none is configured
  const std::unique_ptr<core::PlaceMemory> memory_;
  KeptScans scans_;
  SensorExaminer examiner_;
  tf2::BufferCore buffer_;
  ros::Publisher scan_grid_;
  ros::Publisher scan_cells_;
  AnswerPublisher answer_publisher_;
  DrivePublisher drive_publisher_;
  MapPublisher map_publisher_;
  FusedMapPublisher fused_map_publisher_;
  std::chrono::nanoseconds published_pose_{0};  ///< stamp of the newest one of the drive
  SurveyFeed survey_feed_;
  MapDriver driver_;
  TransformInput transforms_;
  MapFrameBroadcaster map_frame_broadcaster_;
  DriveLease drive_lease_;
  EchoListener echoes_;
  RobotFinder robot_finder_;
  GoServer go_server_;
  ExploreServer explore_server_;
  ScanServer scan_server_;
  LiveParameters live_parameters_;
  diagnostic_updater::Updater diagnostics_;
  ros::SteadyTimer diagnostics_timer_;
  ros::SteadyTimer health_timer_;
  int ticks_without_time_ = 0;
  PlaceClicks clicks_;
  PlaceHandles handles_;
  DriveServices drive_services_;
  PlaceServices services_;  ///< ends with the next two: changes come from there
  RouteServices route_services_;
  StoreServices store_services_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_PLACE_MEMORY_NODE_H
