#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_SERVICES_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_SERVICES_H

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <place_memory/JudgeClosure.h>
#include <place_memory/Relocalize.h>
#include <place_memory/SetMode.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/base/guarded_queue.h"
#include "node/drive/map_driver.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// What a drive is told by others: ~set_mode, ~relocalize, ~judge_closure and initialpose, on a
/// thread of its own.
class DriveServices {
 public:
  /// All must outlive it.
  DriveServices(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                MapDriver& driver, const core::PlaceMemory& memory,
                const config::Parameters& parameters);
  ~DriveServices();
  DriveServices(const DriveServices&) = delete;
  DriveServices& operator=(const DriveServices&) = delete;

  /// The mode of the start, as the parameter has it; what is wrong is said in the log.
  void begin();

 private:
  using InitialPose = geometry_msgs::PoseWithCovarianceStamped;

  SetMode::Response setMode(config::Mode mode);
  void onSetMode(const SetMode::Request& request, SetMode::Response& response);
  void onRelocalize(Relocalize::Response& response);
  void onJudgeClosure(const JudgeClosure::Request& request, JudgeClosure::Response& response);
  void judge(core::PlaceId place, bool confirm, JudgeClosure::Response& response);
  void onInitialPose(const ros::MessageEvent<InitialPose const>& event);
  std::string problemOf(const InitialPose& message) const;

  MapDriver& driver_;
  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;
  GuardedQueue queue_{"the drive"};
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber initialpose_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_SERVICES_H
