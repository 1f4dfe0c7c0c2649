#ifndef PLACE_MEMORY_CORE_MAP_CHANGE_H
#define PLACE_MEMORY_CORE_MAP_CHANGE_H

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

struct PlaceAdded {
  Place place;
  std::shared_ptr<const EvidenceGrid> grid;  ///< as learned
  /// Of the scan it was learned from, in the place's frame; nullptr where they are not known.
  std::shared_ptr<const std::vector<SonarReading>> readings;
};

struct PlaceMoved {
  PlaceId id = kNoPlace;
  Pose2d map_from_place;
  SessionId session = kNoSession;  ///< to which it belongs from now on
};

struct PlaceRenamed {
  PlaceId id = kNoPlace;
  std::string label;
};

struct GridAdapted {
  PlaceId id = kNoPlace;
  std::shared_ptr<const EvidenceGrid> grid;  ///< takes the place of the one before
};

/// The place goes, and its links with it.
struct PlaceRemoved {
  PlaceId id = kNoPlace;
};

/// The link is there from now on; where there was one between the two, this one takes its place.
struct LinkAdded {
  PlaceLink link;
  std::optional<Traversal> traversal{};  ///< by which it was found; goes into the history
};

struct LinkRemoved {
  PlaceId first = kNoPlace;
  PlaceId second = kNoPlace;
};

/// What is known of going along a link from one end to the other is this from now on.
struct LinkLearned {
  PlaceId from = kNoPlace;
  PlaceId to = kNoPlace;
  LinkDirection direction;
  std::optional<Traversal> traversal{};  ///< from which it was learned; goes into the history
};

/// Every place and every link goes.
struct MapCleared {};

using MapEdit = std::variant<PlaceAdded, PlaceMoved, PlaceRenamed, GridAdapted, PlaceRemoved,
                             LinkAdded, LinkRemoved, LinkLearned, MapCleared>;

/// One atomic change of the map: applied to map, index and store in one transaction or not at all,
/// then handed to listeners.
struct MapChange {
  std::uint64_t version = 0;          ///< of the map once it is applied: one more than before
  std::chrono::nanoseconds stamp{0};  ///< when it was made; kept, so that it survives a restart
  std::vector<MapEdit> edits;
};

/// A change of the map as its history tells of it.
struct PastChange {
  std::uint64_t version = 0;          ///< of the map after it
  std::chrono::nanoseconds stamp{0};  ///< when it was made
  std::string words;                  ///< what it did, as: learned "kitchen"
  bool can_be_undone = true;          ///< what it overwrote was not too much to be kept
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_CHANGE_H
