#ifndef PLACE_MEMORY_NODE_ANSWER_PLACE_CLICKS_H
#define PLACE_MEMORY_NODE_ANSWER_PLACE_CLICKS_H

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <vector>

#include "config/parameters.h"
#include "node/answer/answer_publisher.h"
#include "node/names/node_names.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Does what a person chooses of a place in rviz: shows its grid where it lies, publishes the route
/// to it on ~route, latched, or passes on whether the robot is there.
class PlaceClicks {
 public:
  /// Where the robot may be; nothing: as the memory has it.
  using Belief = std::function<std::vector<core::RouteStart>()>;
  /// A person says whether the robot is at the place.
  using Judge = std::function<void(core::PlaceId, bool is_there)>;

  /// All have to outlive it.
  PlaceClicks(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
              AnswerPublisher& answers, Belief belief, Judge judge,
              const config::Parameters& parameters);

  /// Throws PlaceMemoryError. Renaming is the panel's business: it knows a new label.
  void choose(core::PlaceId id, PlaceEntry entry);

 private:
  void showRoute(core::PlaceId id);

  core::PlaceMemory& memory_;
  AnswerPublisher& answers_;
  const Belief belief_;
  const Judge judge_;
  const config::Parameters& parameters_;
  ros::Publisher route_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_PLACE_CLICKS_H
