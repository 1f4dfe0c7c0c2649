#include "node/map/map_frame_broadcaster.h"

#include <geometry_msgs/TransformStamped.h>

#include <chrono>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

constexpr double kPeriod = 0.1;  // [s]
constexpr std::chrono::milliseconds kAhead(200);

}  // namespace

MapFrameBroadcaster::MapFrameBroadcaster(ros::NodeHandle& node, const core::PlaceMemory& memory,
                                         const config::Parameters& parameters)
    : memory_(memory), parameters_(parameters) {
  if (!parameters_.tf_broadcast) return;
  timer_ =
      node.createTimer(ros::Duration(kPeriod), [this](const ros::TimerEvent&) { broadcast(); });
}

void MapFrameBroadcaster::broadcast() {
  const std::chrono::nanoseconds now = rosNow();
  const core::Whereabouts whereabouts = memory_.whereabouts();
  if (now.count() == 0 || whereabouts.apart || !whereabouts.map_from_odom) return;
  const geometry_msgs::Pose pose = toPose(*whereabouts.map_from_odom);
  geometry_msgs::TransformStamped message;
  message.header = makeHeader(parameters_.map_frame, toRosTime(now + kAhead));
  message.child_frame_id = parameters_.odom_frame;
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.rotation = pose.orientation;
  broadcaster_.sendTransform(message);
}

}  // namespace place_memory::node
