#include "node/answer/answer_publisher.h"

#include <ros/console.h>
#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>

#include "node/base/cell_marker.h"
#include "node/base/conversions.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

constexpr double kRecalledLevel = 0.01;    // below the scan's cells [m]
constexpr std::size_t kLikelyPlaces = 10;  // that are drawn

}  // namespace

AnswerPublisher::AnswerPublisher(ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                                 const config::Parameters& parameters)
    : memory_(memory),
      parameters_(parameters),
      matched_grid_(private_node.advertise<nav_msgs::OccupancyGrid>(kMatchedGridTopic, 1, true)),
      matched_cells_(
          private_node.advertise<visualization_msgs::Marker>(kMatchedCellsTopic, 1, true)),
      answer_markers_(
          private_node.advertise<visualization_msgs::MarkerArray>(kAnswerMarkersTopic, 1, true)),
      recognition_(private_node.advertise<Recognition>(kRecognitionTopic, 1, true)),
      current_place_(private_node.advertise<std_msgs::String>(kCurrentPlaceTopic, 1, true)),
      pose_(private_node.advertise<geometry_msgs::PoseWithCovarianceStamped>(kPoseTopic, 1, true)) {
  publishCurrentPlace();
}

void AnswerPublisher::publish(const core::Scan& scan, const core::PlaceMemory::Answer& answer,
                              const Recognition& message) {
  if (answer.superseded) return;
  const Recalled recalled = recall(scan, answer.recognition);
  const std_msgs::Header header = makeHeader(scanFrame(parameters_), toRosTime(scan.end));
  const nav_msgs::OccupancyGrid grid =
      toOccupancyGrid(recalled.grid, recalled.odom_from_place, header, parameters_.sonar.prior);
  const visualization_msgs::Marker cells =
      toCellMarker(recalled.grid, recalled.odom_from_place, header, kRecalledColor, kRecalledLevel);
  const visualization_msgs::MarkerArray markers =
      toMarkers(likelyPlaces(answer.recognition), message.header);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answer.whereabouts.version < newest_) return;
  newest_ = answer.whereabouts.version;
  answer_ = std::make_shared<const ScanAnswer>(ScanAnswer{answer.recognition.verdict,
                                                          answer.recognition.matches, scan.grid,
                                                          scan.odom_from_scan, scan.robot_in_scan});
  recognition_.publish(message);
  matched_grid_.publish(grid);
  matched_cells_.publish(cells);
  answer_markers_.publish(markers);
  if (answer.recognition.verdict == core::Verdict::kRecognized) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header = message.header;
    pose.pose = message.pose;
    pose_.publish(pose);
  }
  publishCurrentPlaceLocked(memory_.whereabouts());
}

void AnswerPublisher::overtake() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const core::Whereabouts whereabouts = memory_.whereabouts();
  newest_ = whereabouts.version;
  answer_.reset();
  publishCurrentPlaceLocked(whereabouts);
}

std::shared_ptr<const ScanAnswer> AnswerPublisher::newest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return answer_;
}

void AnswerPublisher::showPlace(core::PlaceId id) {
  const core::EvidenceGrid grid = memory_.grid(id);
  const std::optional<core::Place> place = memory_.place(id);
  if (!place) return;  // it went meanwhile
  const std_msgs::Header header = makeHeader(parameters_.map_frame, ros::Time());
  const std::lock_guard<std::mutex> lock(mutex_);
  matched_grid_.publish(
      toOccupancyGrid(grid, place->map_from_place, header, parameters_.sonar.prior));
  matched_cells_.publish(
      toCellMarker(grid, place->map_from_place, header, kRecalledColor, kRecalledLevel));
}

void AnswerPublisher::publishPose(const geometry_msgs::PoseWithCovarianceStamped& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  pose_.publish(pose);
}

void AnswerPublisher::publishCurrentPlace() {
  const std::lock_guard<std::mutex> lock(mutex_);
  publishCurrentPlaceLocked(memory_.whereabouts());
}

void AnswerPublisher::publishCurrentPlaceLocked(const core::Whereabouts& whereabouts) {
  if (whereabouts.current_label == published_label_) return;
  std_msgs::String message;
  message.data = whereabouts.current_label;
  current_place_.publish(message);
  published_label_ = whereabouts.current_label;
}

// Without a place a grid of unsensed cells, because subscribers keep showing the last grid.
AnswerPublisher::Recalled AnswerPublisher::recall(const core::Scan& scan,
                                                  const core::Recognition& found) const {
  Recalled recalled{core::EvidenceGrid(scan.grid.geometry()), scan.odom_from_scan};
  if (found.verdict == core::Verdict::kUnknown) return recalled;
  const core::PlaceMatch& match = found.matches.front();
  recalled.odom_from_place = scan.odom_from_scan * match.place_from_scan.inverse();
  try {
    recalled.grid = memory_.grid(match.id);
  } catch (const core::PlaceMemoryError& error) {
    ROS_WARN("The matched grid is not published: %s", error.what());
  }
  return recalled;
}

std::vector<LikelyPlace> AnswerPublisher::likelyPlaces(const core::Recognition& found) const {
  std::vector<LikelyPlace> likely;
  const std::size_t count = std::min(found.matches.size(), kLikelyPlaces);
  for (std::size_t i = 0; i < count; ++i) {
    const core::PlaceMatch& match = found.matches[i];
    const std::optional<core::Place> place = memory_.place(match.id);
    if (place) likely.push_back({place->map_from_place, match.probability});
  }
  return likely;
}

}  // namespace place_memory::node
