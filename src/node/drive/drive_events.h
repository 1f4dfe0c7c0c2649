#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_EVENTS_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_EVENTS_H

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/mapper.h"
#include "node/drive/mapper_feed.h"

namespace place_memory::node {

/// As MapEvent.msg has it.
struct DriveEvent {
  std::uint8_t kind = 0;
  std::chrono::nanoseconds stamp{0};
  std::vector<core::PlaceId> places;
  std::string sentence;
};

/// Finds in what a mapper tells what people want to hear of.
class DriveEvents {
 public:
  using LabelOf = std::function<std::string(core::PlaceId)>;

  /// `largest_jump` [m]: see drive/largest_jump.
  DriveEvents(double largest_jump, LabelOf label)
      : largest_jump_(largest_jump), label_(std::move(label)) {}

  /// What happened up to that moment of odometry. `map_from_odom`: as it is after it.
  std::vector<DriveEvent> update(const OdometryMoment& now,
                                 const std::vector<core::ScanDecision>& decisions,
                                 const std::vector<core::MapperEvent>& of_map,
                                 const std::optional<core::Pose2d>& map_from_odom);

 private:
  DriveEvent eventOf(const core::ScanDecision& decision) const;
  DriveEvent eventOf(const core::MapperEvent& event) const;
  std::string labels(const std::vector<core::PlaceId>& places) const;

  double largest_jump_;
  LabelOf label_;
  std::optional<core::Pose2d> map_from_odom_;  ///< at the moment before
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_EVENTS_H
