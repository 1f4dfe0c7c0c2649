#ifndef PLACE_MEMORY_CORE_PLACE_GRAPH_H
#define PLACE_MEMORY_CORE_PLACE_GRAPH_H

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/export.h"

namespace place_memory::core {

/// The robot went from one of these places to the other; links have no direction (paper 7).
struct PlaceLink {
  PlaceId first = kNoPlace;  ///< the lower id
  PlaceId second = kNoPlace;

  bool operator==(const PlaceLink& other) const {
    return first == other.first && second == other.second;
  }
};

/// The topological/metric map without the grids (paper 3, figure 4): places by id and by label, and
/// the links between them.
///
/// Ordered maps instead of a Boost.Graph adjacency list, because the ids stay valid in a copy and
/// when places are removed, which vertex descriptors do not.
class PLACE_MEMORY_PUBLIC PlaceGraph {
 public:
  std::size_t size() const { return nodes_.size(); }

  /// The place, or nullptr. Valid until the graph changes.
  const Place* find(PlaceId id) const;
  const Place* find(const std::string& label) const;

  /// By rising id.
  std::vector<Place> places() const;
  /// By rising first id, then by rising second id.
  std::vector<PlaceLink> links() const;
  /// Highest id of the places in the graph, kNoPlace where there is none.
  PlaceId lastId() const { return nodes_.empty() ? kNoPlace : nodes_.rbegin()->first; }

  /// Throws std::invalid_argument where the id or the label is in the graph.
  void add(const Place& place);
  /// Throws std::invalid_argument where there is no such place, or another one has the label.
  void rename(PlaceId id, const std::string& label);
  /// Removes the place and its links; nothing happens where there is no such place.
  void remove(PlaceId id);
  /// Linking twice changes nothing. Throws std::invalid_argument where a place is missing or both
  /// are the same.
  void link(PlaceId one, PlaceId other);
  void clear();

 private:
  struct Node {
    Place place;
    std::set<PlaceId> neighbours;
  };

  Node& node(PlaceId id);

  std::map<PlaceId, Node> nodes_;
  std::unordered_map<std::string, PlaceId> id_of_label_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_GRAPH_H
