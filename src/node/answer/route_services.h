#ifndef PLACE_MEMORY_NODE_ANSWER_ROUTE_SERVICES_H
#define PLACE_MEMORY_NODE_ANSWER_ROUTE_SERVICES_H

#include <nav_msgs/GetPlan.h>
#include <place_memory/PlanRoute.h>
#include <place_memory/ReportTraversal.h>
#include <place_memory/SetLink.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/base/guarded_queue.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The services that plan routes and tell links what was found of them. They are answered on a
/// thread of their own, so that a plan comes while a scan is matched or the robot drives.
class RouteServices {
 public:
  /// Where the robot may be; nothing: as the memory has it.
  using Belief = std::function<std::vector<core::RouteStart>()>;

  /// All have to outlive it.
  RouteServices(const ros::NodeHandle& private_node, core::PlaceMemory& memory, Belief belief,
                const config::Parameters& parameters);
  /// Waits for the thread.
  ~RouteServices();
  RouteServices(const RouteServices&) = delete;
  RouteServices& operator=(const RouteServices&) = delete;

 private:
  void plan(const PlanRoute::Request& request, PlanRoute::Response& response);
  void report(const ReportTraversal::Request& request, ReportTraversal::Response& response);
  void setLink(const SetLink::Request& request, SetLink::Response& response);
  /// Has no status: an empty path where there is no route, and the reason in the log.
  void makePlan(const nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);

  /// Throws PlaceMemoryError.
  core::PlaceId idOf(core::PlaceId id, const std::string& label) const;
  double oddsOf(core::PlaceId from, core::PlaceId to) const;
  /// Nothing where the frame is another one or the pose is not finite.
  std::optional<core::Pose2d> poseIn(const geometry_msgs::PoseStamped& pose) const;

  core::PlaceMemory& memory_;
  const Belief belief_;
  const config::Parameters& parameters_;
  // The spinner stops before the queue it works on goes.
  GuardedQueue queue_{"routes"};
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_ROUTE_SERVICES_H
