#ifndef PLACE_MEMORY_NODE_ANSWER_ANSWER_PUBLISHER_H
#define PLACE_MEMORY_NODE_ANSWER_ANSWER_PUBLISHER_H

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <place_memory/Recognition.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/answer/answer_markers.h"
#include "node/go/view_asker.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/scan.h"

namespace place_memory::node {

/// Publishes where the robot is: ~recognition, ~pose, ~matched_grid and ~current_place, and for
/// rviz ~matched_cells and ~answer_markers, all latched. Thread-safe.
///
/// An answer that was overtaken, by a newer one, by a place that was learned, or because the robot
/// was carried, stays with the client who asked: who subscribes gets the newest.
class AnswerPublisher {
 public:
  /// `memory` and `parameters` must outlive the publisher.
  AnswerPublisher(ros::NodeHandle& private_node, const core::PlaceMemory& memory,
                  const config::Parameters& parameters);

  /// `message` is `answer` as the client gets it.
  void publish(const core::Scan& scan, const core::PlaceMemory::Answer& answer,
               const Recognition& message);

  /// The newest answer that nothing has overtaken; nullptr: there is none.
  std::shared_ptr<const ScanAnswer> newest() const;

  /// A place was learned, or the robot was carried: answers to what was asked before are overtaken.
  void overtake();

  /// Recalls a place that nothing was matched with: its grid, where it lies in the map. Throws
  /// PlaceMemoryError.
  void showPlace(core::PlaceId id);

  /// Where a drive has the robot.
  void publishPose(const geometry_msgs::PoseWithCovarianceStamped& pose);

  /// The current place may have gone, or been renamed.
  void publishCurrentPlace();

 private:
  void publishCurrentPlaceLocked(const core::Whereabouts& whereabouts);
  /// The grid of the best match, and where it aligns in the scan's frame.
  struct Recalled {
    core::EvidenceGrid grid;
    core::Pose2d odom_from_place;
  };
  Recalled recall(const core::Scan& scan, const core::Recognition& found) const;
  std::vector<LikelyPlace> likelyPlaces(const core::Recognition& found) const;

  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;

  ros::Publisher matched_grid_;
  ros::Publisher matched_cells_;
  ros::Publisher answer_markers_;
  ros::Publisher recognition_;
  ros::Publisher current_place_;
  ros::Publisher pose_;

  /// Held while something is published, so that the last message is the newest.
  mutable std::mutex mutex_;
  std::uint64_t newest_ = 0;  ///< version of the whereabouts after the newest answer
  std::shared_ptr<const ScanAnswer> answer_;
  std::optional<std::string> published_label_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_ANSWER_PUBLISHER_H
