#ifndef PLACE_MEMORY_CORE_PLACE_MAP_H
#define PLACE_MEMORY_CORE_PLACE_MAP_H

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/export.h"

namespace place_memory::core {

struct MapChange;

/// What is known of going along a link one way. What is older counts for less, see
/// LinkLearningOptions.
struct LinkDirection {
  std::uint32_t succeeded = 0;       ///< traversals
  std::uint32_t failed = 0;          ///< traversals that were begun and given up
  std::chrono::nanoseconds last{0};  ///< newest traversal, or word of a person; 0: none
  double through = 0.0;              ///< traversals that succeeded as they count at `last`, >= 0
  double blocked = 0.0;              ///< those that failed, likewise
  double time = 0.0;                 ///< that one takes which succeeds, mean [s]; 0: none was timed
  double time_sigma = 0.0;           ///< its spread [s]
  double lost_time = 0.0;            ///< that one takes which fails, mean [s]; 0: none was timed
  double toll = 0.0;                 ///< a person's: routes count so much time more [s], >= 0
  bool forbidden = false;            ///< by a person: no route goes here

  bool operator==(const LinkDirection& other) const {
    return succeeded == other.succeeded && failed == other.failed && last == other.last &&
           through == other.through && blocked == other.blocked && time == other.time &&
           time_sigma == other.time_sigma && lost_time == other.lost_time && toll == other.toll &&
           forbidden == other.forbidden;
  }
};

/// The robot went along a link, or tried to.
struct Traversal {
  PlaceId from = kNoPlace;
  PlaceId to = kNoPlace;
  std::chrono::nanoseconds begin{0};  ///< when it left; as `end`: how long it took is not known
  std::chrono::nanoseconds end{0};    ///< when it arrived, or gave up
  bool succeeded = true;
  std::string source;  ///< who says so: UTF-8, at most 255 bytes

  bool operator==(const Traversal& other) const {
    return from == other.from && to == other.to && begin == other.begin && end == other.end &&
           succeeded == other.succeeded && source == other.source;
  }
};

/// The robot went from one of these places to the other (paper 7).
struct PlaceLink {
  PlaceId first = kNoPlace;  ///< the lower id
  PlaceId second = kNoPlace;
  /// Relative pose as odometry measured it on the way, not as the map has it now.
  Pose2d first_from_second;
  /// Of first_from_second: row-major 3 x 3 over x [m], y [m], yaw [rad], in first's frame. The
  /// noise of odometry is taken as: 0.05 m and 10 % of the straight way along x and along y, 0.1
  /// rad of yaw, independent of each other. Where the way began at a place that was recognized, and
  /// not at one that was learned, the covariance of that alignment is added. Without odometry
  /// kUnknownVariance stands for x, y and yaw.
  std::array<double, 9> covariance{};
  LinkDirection forward;   ///< first to second
  LinkDirection backward;  ///< second to first

  bool operator==(const PlaceLink& other) const {
    return first == other.first && second == other.second &&
           first_from_second == other.first_from_second && covariance == other.covariance &&
           forward == other.forward && backward == other.backward;
  }
};

/// Says that a measurement tells nothing [m^2, rad^2].
constexpr double kUnknownVariance = 1e6;

/// The topological/metric map without the grids (paper 3, figure 4): the one owner of where places
/// lie, and of the relative poses along links.
///
/// Places stand in one array, by rising id. A place with a new highest id is added at its end,
/// which costs some microseconds however many there are. Not thread-safe.
class PLACE_MEMORY_PUBLIC PlaceMap {
 public:
  /// Without a place, at version 0.
  PlaceMap() = default;
  /// As it was kept. Throws std::invalid_argument where an id or a label comes twice, a label is no
  /// label, a number is not finite, or a link joins what is not there.
  PlaceMap(std::vector<Place> places, const std::vector<PlaceLink>& links, std::uint64_t version,
           std::chrono::nanoseconds stamp);

  std::size_t size() const { return places_.size(); }
  /// Counts changes: that of the newest one.
  std::uint64_t version() const { return version_; }
  /// Of the newest change; 0: there was none.
  std::chrono::nanoseconds stamp() const { return stamp_; }

  /// The place, or nullptr. Valid until the map changes.
  const Place* find(PlaceId id) const;
  const Place* find(const std::string& label) const;
  /// The link between these two, in whatever order, or nullptr. Valid until the map changes.
  const PlaceLink* findLink(PlaceId one, PlaceId other) const;

  /// By rising id. Valid until the map changes.
  const std::vector<Place>& places() const { return places_; }
  /// By rising first id, then by rising second id.
  std::vector<PlaceLink> links() const;
  /// Calls with each of them, in this order.
  void forEachLink(const std::function<void(const PlaceLink&)>& call) const;
  /// The places that this one is linked to, by rising id.
  std::vector<PlaceId> neighbours(PlaceId id) const;
  /// Highest id of the places in the map, kNoPlace where there is none.
  PlaceId lastId() const { return places_.empty() ? kNoPlace : places_.back().id; }

  /// Throws std::invalid_argument, saying why, where the change does not fit the map: its version
  /// is not the next one, a label or an id is taken, there is no such place or link, a pose or a
  /// covariance is not finite, a place would be linked to itself. Grids and readings are not looked
  /// at. The edits count one after the other.
  void check(const MapChange& change) const;
  /// Makes all edits of the change, and takes on its version and stamp. Throws what check() throws;
  /// the map is then as it was.
  void apply(const MapChange& change);

 private:
  using Ends = std::pair<PlaceId, PlaceId>;
  class Editor;

  std::size_t indexOf(PlaceId id) const;  ///< where the id is or belongs in places_

  std::vector<Place> places_;
  std::unordered_map<std::string, PlaceId> id_of_label_;
  std::map<Ends, PlaceLink> links_;
  std::unordered_map<PlaceId, std::vector<PlaceId>> neighbours_;  ///< of places that have any
  std::uint64_t version_ = 0;
  std::chrono::nanoseconds stamp_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_MAP_H
