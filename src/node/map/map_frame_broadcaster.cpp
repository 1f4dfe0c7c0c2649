#include "node/map/map_frame_broadcaster.h"

#include <geometry_msgs/TransformStamped.h>

#include <chrono>
#include <utility>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"

namespace place_memory::node {

MapFrameBroadcaster::MapFrameBroadcaster(ros::NodeHandle& node, MapFromOdom map_from_odom,
                                         const config::Parameters& parameters)
    : map_from_odom_(std::move(map_from_odom)), parameters_(parameters) {
  if (!parameters_.tf_broadcast) return;
  timer_ = node.createTimer(ros::Duration(1.0 / parameters_.tf_rate),
                            [this](const ros::TimerEvent&) { broadcast(); });
}

void MapFrameBroadcaster::broadcast() {
  const std::chrono::nanoseconds now = rosNow();
  if (now.count() == 0) return;
  const std::optional<core::Pose2d> map_from_odom = map_from_odom_();
  if (!map_from_odom) return;
  const geometry_msgs::Pose pose = toPose(*map_from_odom);
  geometry_msgs::TransformStamped message;
  message.header = makeHeader(parameters_.map_frame,
                              toRosTime(now + toNanoseconds(parameters_.transform_tolerance)));
  message.child_frame_id = parameters_.odom_frame;
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.rotation = pose.orientation;
  broadcaster_.sendTransform(message);
}

}  // namespace place_memory::node
