#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_PUBLISHER_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_PUBLISHER_H

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <place_memory/PlaceBelief.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <chrono>
#include <optional>

#include "config/parameters.h"
#include "node/drive/map_driver.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// "off", "map" or "localize".
const char* nameOf(config::Mode mode);

/// Publishes what a drive tells: ~mode and ~belief, latched, ~events, and where
/// drive/initialpose asks for it, initialpose. Thread-safe.
class DrivePublisher {
 public:
  /// `memory` and `parameters` must outlive it.
  DrivePublisher(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                 const core::PlaceMemory& memory, const config::Parameters& parameters);

  void publish(config::Mode mode) const;
  void publish(const DriveEvent& event) const;
  void publish(const MapDriver::Step& step) const;

  PlaceBelief toMessage(const core::BeliefSummary& belief, std::chrono::nanoseconds stamp) const;
  /// Of the robot in the map; nothing where that is not known.
  std::optional<geometry_msgs::PoseWithCovarianceStamped> poseOf(const MapDriver::Step& step) const;

 private:
  const core::PlaceMemory& memory_;
  const config::Parameters& parameters_;
  ros::Publisher mode_;
  ros::Publisher belief_;
  ros::Publisher events_;
  ros::Publisher initialpose_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_PUBLISHER_H
