#ifndef PLACE_MEMORY_CORE_MAPPING_PLACE_SHELF_H
#define PLACE_MEMORY_CORE_MAPPING_PLACE_SHELF_H

#include <map>
#include <optional>
#include <vector>

#include "core/map/place_locator.h"
#include "core/mapping/place_matcher.h"
#include "core/mapping/scan_graph.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// The frame of a place's grid in that of the base: about the middle of what it shows, its axes
/// along the map's when it was laid out.
inline Pose2d baseFromGrid(const ScanNode& node, double laid_yaw) {
  return node.seen * Pose2d{0.0, 0.0, -laid_yaw};
}

/// The nodes that are places, and their grids: by session, since places of different sessions lie
/// in different frames.
class PlaceShelf {
 public:
  PlaceShelf(const RecognizerOptions& options, const SonarModel& sonar, double cell_size)
      : options_(options), sonar_(sonar), geometry_{cell_size} {}

  /// Makes a node a place. It is matched against once it is ripe. `id`: higher than any that was
  /// given; kNoPlace: the next one.
  PlaceId add(NodeIndex at, ScanGraph& graph, PlaceId id = kNoPlace);
  void remove(PlaceId id, ScanGraph& graph);
  /// Lets places be matched against that share no reading with a stretch that begins at `way`.
  void ripen(double way, ScanGraph& graph);
  /// After poses changed: follows them, and lays grids anew along headings that were corrected.
  void follow(ScanGraph& graph);
  /// Places of a session are another's now.
  void join(int session, int into, const ScanGraph& graph);

  /// After nodes came to be of another session: moves their places.
  void resort(ScanGraph& graph);

  /// After nodes changed their indices: those that were and those that are.
  void renumber(const std::vector<std::optional<NodeIndex>>& now);
  /// Takes up the places of a graph that was kept; the shelf is empty before. New places get ids
  /// from `next_id` on, and higher than all there are.
  void restore(ScanGraph& graph, PlaceId next_id);
  /// Ids from here on were never given.
  PlaceId nextId() const { return last_id_ + 1; }

  NodeIndex nodeOf(PlaceId id) const { return node_of_.at(id); }
  bool has(PlaceId id) const { return node_of_.count(id) > 0; }
  const std::map<PlaceId, NodeIndex>& places() const { return node_of_; }
  /// Of a session's ripe places; nullptr where it has none.
  const PlaceMatcher* matcher(int session) const;
  bool ripe(PlaceId id) const { return home_of_.count(id) > 0; }

  using Near = PlaceLocator::Near;
  /// Places of a session within `radius` [m], nearest first.
  std::vector<Near> near(const Pose2d& pose, int session, double radius, bool only_ripe) const;
  /// Ripe places the middle of which is so near to that of what is seen from `pose`, likewise.
  /// `seen`: that middle, beside `pose`.
  std::vector<Near> nearSeen(const Pose2d& pose, const Pose2d& seen, int session,
                             double radius) const;

 private:
  void shelve(PlaceId id, ScanGraph& graph);
  std::vector<Near> near(const std::map<int, PlaceLocator>& locators, const Pose2d& pose,
                         int session, double radius, bool only_ripe) const;
  void put(PlaceId id, const ScanNode& node);
  void locate(const ScanGraph& graph);

  RecognizerOptions options_;
  SonarModel sonar_;
  GridGeometry geometry_;
  PlaceId last_id_ = 0;
  std::map<PlaceId, NodeIndex> node_of_;
  std::map<PlaceId, int> home_of_;  ///< session in whose matcher a ripe place is
  std::vector<PlaceId> unripe_;
  std::map<int, PlaceMatcher> matchers_;  ///< by session
  std::map<int, PlaceLocator> locators_;  ///< likewise, of all places
  std::map<int, PlaceLocator> seen_;      ///< likewise, by the middles of what they show
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_PLACE_SHELF_H
