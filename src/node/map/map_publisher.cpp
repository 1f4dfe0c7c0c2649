#include "node/map/map_publisher.h"

#include <place_memory/MapChange.h>
#include <place_memory/PlaceGraph.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "node/map/map_messages.h"
#include "node/map/place_markers.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

// Changes that wait for a slow subscriber; who falls back further gets the whole by ~get_graph.
constexpr std::uint32_t kChanges = 10000;

constexpr std::chrono::seconds kPause(1);  // between two whole maps

// Labels follow a robot that has gone so far [m].
constexpr double kLabelStep = 5.0;

std::size_t labelsIn(const visualization_msgs::MarkerArray& array) {
  return static_cast<std::size_t>(
      std::count_if(array.markers.begin(), array.markers.end(),
                    [](const auto& marker) { return !marker.text.empty(); }));
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle& private_node, core::PlaceMemory& memory,
                           const config::Parameters& parameters, LocateRobot locate_robot)
    : memory_(memory),
      parameters_(parameters),
      locate_robot_(std::move(locate_robot)),
      map_changes_(private_node.advertise<MapChange>(kMapChangesTopic, kChanges, true)),
      place_graph_(private_node.advertise<PlaceGraph>(kPlaceGraphTopic, 1, true)),
      place_markers_(
          private_node.advertise<visualization_msgs::MarkerArray>(kPlaceMarkersTopic, 1, true)),
      whole_map_(
          "The map is not published", [this] { publishWholeMap(); }, kPause) {
  core::MapChange nothing;
  nothing.version = memory_.version();
  nothing.stamp = memory_.map().stamp;
  map_changes_.publish(toMessage(nothing, parameters_.map_frame));
  memory.listen([this](const core::MapChange& change) { publishChange(change); });
  whole_map_.request();
}

void MapPublisher::publishChange(const core::MapChange& change) {
  map_changes_.publish(toMessage(change, parameters_.map_frame));
  whole_map_.request();
}

void MapPublisher::follow() {
  const std::optional<core::Pose2d> robot = locate_robot_();
  if (!robot) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (all_labelled_) return;
  if (labels_around_ &&
      std::hypot(robot->x - labels_around_->x, robot->y - labels_around_->y) < kLabelStep) {
    return;
  }
  whole_map_.request();
}

void MapPublisher::publishWholeMap() {
  const core::MapSnapshot map = memory_.map();
  const PlaceGraph graph = toMessage(map, parameters_.map_frame);
  place_graph_.publish(graph);
  const std::optional<core::Pose2d> robot = locate_robot_();
  const visualization_msgs::MarkerArray markers =
      toMarkers(map, robot.value_or(core::Pose2d()),
                static_cast<std::size_t>(parameters_.markers.labels), graph.header);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    labels_around_ = robot;
    all_labelled_ = labelsIn(markers) == map.places.size();
  }
  place_markers_.publish(markers);
}

}  // namespace place_memory::node
