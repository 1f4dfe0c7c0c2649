#include "node/map/memory_publisher.h"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/console.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include "node/conversions.h"
#include "node/map/place_markers.h"
#include "node/node_names.h"

namespace place_memory::node {
namespace {

template <class Message>
ros::Publisher advertiseLatched(ros::NodeHandle& node, const char* topic) {
  return node.advertise<Message>(topic, 1, true);
}

}  // namespace

MemoryPublisher::MemoryPublisher(ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                                 const config::Parameters& parameters)
    : memory_(memory),
      parameters_(parameters),
      scan_grid_(advertiseLatched<nav_msgs::OccupancyGrid>(private_node, kScanGridTopic)),
      matched_grid_(advertiseLatched<nav_msgs::OccupancyGrid>(private_node, kMatchedGridTopic)),
      place_graph_(advertiseLatched<PlaceGraph>(private_node, kPlaceGraphTopic)),
      place_markers_(
          advertiseLatched<visualization_msgs::MarkerArray>(private_node, kPlaceMarkersTopic)),
      recognition_(advertiseLatched<Recognition>(private_node, kRecognitionTopic)),
      current_place_(advertiseLatched<std_msgs::String>(private_node, kCurrentPlaceTopic)),
      pose_(advertiseLatched<geometry_msgs::PoseWithCovarianceStamped>(private_node, kPoseTopic)) {
  publishMap();
}

void MemoryPublisher::publishScan(const core::Scan& scan) {
  scan_grid_.publish(toOccupancyGrid(scan.grid, scan.odom_from_scan,
                                     makeHeader(scanFrame(), toRosTime(scan.end)),
                                     parameters_.sonar.prior));
}

void MemoryPublisher::publishMap() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const core::MapSnapshot map = memory_.map();
  const std_msgs::Header header = makeHeader(parameters_.map_frame, ros::Time::now());
  place_graph_.publish(toMessage(map, header));
  place_markers_.publish(toMarkers(map, header));
  publishCurrentPlaceLocked();
}

void MemoryPublisher::publishLearned(core::PlaceId id) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    current_ = id;
  }
  publishMap();
}

void MemoryPublisher::publishRecognition(const core::Scan& scan,
                                         const core::PlaceMemory::Answer& answer,
                                         const Recognition& message) {
  const core::Recognition& found = answer.recognition;
  const bool is_recognized = found.verdict == core::Verdict::kRecognized;
  recognition_.publish(message);
  if (is_recognized) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header = message.header;
    pose.pose = message.pose;
    pose_.publish(pose);
  }
  publishMatchedGrid(
      scan, found.verdict == core::Verdict::kUnknown ? core::PlaceMatch() : found.matches.front());
  if (answer.superseded) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  current_ = is_recognized ? found.matches.front().id : core::kNoPlace;
  publishCurrentPlaceLocked();
}

void MemoryPublisher::publishCurrentPlaceLocked() {
  const std::optional<core::Place> place = memory_.place(current_);
  const std::string label = place ? place->label : "";
  if (label == published_label_) return;
  std_msgs::String message;
  message.data = label;
  current_place_.publish(message);
  published_label_ = label;
}

// Without a place a grid of unsensed cells, because subscribers keep showing the last grid.
void MemoryPublisher::publishMatchedGrid(const core::Scan& scan, const core::PlaceMatch& match) {
  core::EvidenceGrid grid(scan.grid.geometry());
  if (match.id != core::kNoPlace) {
    try {
      grid = memory_.grid(match.id);
    } catch (const core::PlaceMemoryError& error) {
      ROS_WARN("The matched grid is not published: %s", error.what());
    }
  }
  matched_grid_.publish(toOccupancyGrid(grid, scan.odom_from_scan * match.place_from_scan.inverse(),
                                        makeHeader(scanFrame(), toRosTime(scan.end)),
                                        parameters_.sonar.prior));
}

const std::string& MemoryPublisher::scanFrame() const {
  return parameters_.odom_frame.empty() ? parameters_.map_frame : parameters_.odom_frame;
}

}  // namespace place_memory::node
