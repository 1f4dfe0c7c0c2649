#include "node/drive/drive_publisher.h"

#include <place_memory/MapEvent.h>
#include <ros/console.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "node/base/conversions.h"
#include "node/drive/belief_markers.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

constexpr std::uint32_t kEvents = 1000;  // that wait for a slow subscriber

}  // namespace

const char* nameOf(config::Mode mode) {
  switch (mode) {
    case config::Mode::kMap:
      return "map";
    case config::Mode::kLocalize:
      return "localize";
    case config::Mode::kOff:
      break;
  }
  return "off";
}

DrivePublisher::DrivePublisher(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                               const core::PlaceMemory& memory,
                               const config::Parameters& parameters)
    : memory_(memory), parameters_(parameters) {
  ros::NodeHandle relative(names), own(private_names);
  mode_ = own.advertise<std_msgs::String>(kModeTopic, 1, true);
  belief_ = own.advertise<PlaceBelief>(kBeliefTopic, 1, true);
  belief_markers_ = own.advertise<visualization_msgs::MarkerArray>(kBeliefMarkersTopic, 1, true);
  events_ = own.advertise<MapEvent>(kEventsTopic, kEvents);
  if (parameters_.drive.initialpose) {
    initialpose_ =
        relative.advertise<geometry_msgs::PoseWithCovarianceStamped>(kInitialPoseTopic, 1);
  }
}

void DrivePublisher::publish(config::Mode mode) const {
  std_msgs::String message;
  message.data = nameOf(mode);
  mode_.publish(message);
}

void DrivePublisher::publish(const DriveEvent& event) const {
  MapEvent message;
  message.stamp = toRosTime(event.stamp);
  message.kind = event.kind;
  message.places = event.places;
  message.sentence = event.sentence;
  events_.publish(message);
  const bool is_trouble = event.kind == MapEvent::TROUBLE || event.kind == MapEvent::LOST;
  if (is_trouble) ROS_WARN("%s", event.sentence.c_str());
  if (!is_trouble) ROS_INFO("%s", event.sentence.c_str());
}

void DrivePublisher::publish(const MapDriver::Step& step) const {
  if (step.belief) publish(toMessage(*step.belief, step.scan_stamp));
  if (!parameters_.drive.initialpose || !step.became_known) return;
  if (const auto pose = poseOf(step)) initialpose_.publish(*pose);
}

void DrivePublisher::publish(const PlaceBelief& belief) const {
  belief_.publish(belief);
  std::vector<geometry_msgs::Pose2D> locations;
  for (const core::PlaceId id : belief.ids) {
    const auto place = memory_.place(id);
    locations.push_back(toPose2D(place ? place->map_from_place : core::Pose2d()));
  }
  belief_markers_.publish(toMarkers(belief, locations));
}

PlaceBelief DrivePublisher::toMessage(const core::BeliefSummary& belief,
                                      std::chrono::nanoseconds stamp) const {
  PlaceBelief message;
  message.header = makeHeader(parameters_.map_frame, toRosTime(stamp));
  for (const core::BelievedPlace& believed : belief.places) {
    const auto place = memory_.place(believed.id);
    message.ids.push_back(believed.id);
    message.labels.push_back(place ? place->label : "");
    message.probabilities.push_back(believed.probability);
  }
  message.off_map = belief.off_map;
  message.p_lost = belief.lost;
  return message;
}

std::optional<geometry_msgs::PoseWithCovarianceStamped> DrivePublisher::poseOf(
    const MapDriver::Step& step) const {
  if (!step.map_from_odom) return std::nullopt;
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header = makeHeader(parameters_.map_frame, toRosTime(step.now.stamp));
  pose.pose = toPoseWithCovariance(*step.map_from_odom * step.now.odom_from_base, step.covariance);
  return pose;
}

}  // namespace place_memory::node
