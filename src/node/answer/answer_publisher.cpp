#include "node/answer/answer_publisher.h"

#include <ros/console.h>
#include <std_msgs/String.h>

#include "node/base/conversions.h"
#include "node/base/node_names.h"

namespace place_memory::node {

AnswerPublisher::AnswerPublisher(ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                                 const config::Parameters& parameters)
    : memory_(memory),
      parameters_(parameters),
      matched_grid_(private_node.advertise<nav_msgs::OccupancyGrid>(kMatchedGridTopic, 1, true)),
      recognition_(private_node.advertise<Recognition>(kRecognitionTopic, 1, true)),
      current_place_(private_node.advertise<std_msgs::String>(kCurrentPlaceTopic, 1, true)),
      pose_(private_node.advertise<geometry_msgs::PoseWithCovarianceStamped>(kPoseTopic, 1, true)) {
  publishCurrentPlace();
}

void AnswerPublisher::publish(const core::Scan& scan, const core::PlaceMemory::Answer& answer,
                              const Recognition& message) {
  if (answer.superseded) return;
  const nav_msgs::OccupancyGrid grid = matchedGrid(scan, answer.recognition);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answer.whereabouts.version < newest_) return;
  newest_ = answer.whereabouts.version;
  recognition_.publish(message);
  matched_grid_.publish(grid);
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
  publishCurrentPlaceLocked(whereabouts);
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
nav_msgs::OccupancyGrid AnswerPublisher::matchedGrid(const core::Scan& scan,
                                                     const core::Recognition& found) const {
  core::EvidenceGrid grid(scan.grid.geometry());
  core::Pose2d odom_from_place = scan.odom_from_scan;
  if (found.verdict != core::Verdict::kUnknown) {
    const core::PlaceMatch& match = found.matches.front();
    odom_from_place = scan.odom_from_scan * match.place_from_scan.inverse();
    try {
      grid = memory_.grid(match.id);
    } catch (const core::PlaceMemoryError& error) {
      ROS_WARN("The matched grid is not published: %s", error.what());
    }
  }
  return toOccupancyGrid(grid, odom_from_place,
                         makeHeader(scanFrame(parameters_), toRosTime(scan.end)),
                         parameters_.sonar.prior);
}

}  // namespace place_memory::node
