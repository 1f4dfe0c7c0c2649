#ifndef PLACE_MEMORY_CORE_ROUTE_LANDMARKS_H
#define PLACE_MEMORY_CORE_ROUTE_LANDMARKS_H

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/route/route_graph.h"

namespace place_memory::core {

/// Lower bounds of what is left of a way, by the triangle inequality over distances to places at
/// the rim of the map (Goldberg and Harrelson 2005, "Computing the shortest path: A* search meets
/// graph theory"). Distances are those of the times that links take, whatever their odds: odds may
/// change and bounds hold.
///
/// A link that becomes quicker than the bounds take it for, or is new, does not spoil them: no way
/// goes along a link twice, so every bound less what all such links undercut is one still.
class Landmarks {
 public:
  using Vertex = RouteGraph::Vertex;

  bool empty() const { return rows_.empty(); }
  void clear() { *this = Landmarks(); }
  /// One search of the whole map for each landmark.
  void prepare(const RouteGraph& graph, const PlaceMap& map);
  /// After the graph has followed the change.
  void follow(const MapChange& change, const RouteGraph& graph, const PlaceMap& map);
  /// Whether so much changed that prepare() would pay.
  bool areWorn() const;

  /// At most what the cheapest way between the two costs [s].
  double bound(Vertex from, Vertex to) const;

 private:
  static constexpr std::size_t kLandmarks = 16;
  using Row = std::array<float, kLandmarks>;  ///< distance to each; not numbers: no way

  static Row noWay();
  /// Whether no way leads from there to the landmarks, which lie on one island.
  bool isOff(Vertex vertex) const;
  void join(Vertex vertex, const Row& near, const RouteGraph& graph, const PlaceMap& map);
  void linkIs(Vertex one, Vertex other, double least);
  void linkIsGone(Vertex one, Vertex other);
  double gap(Vertex one, Vertex other) const;

  std::vector<Row> rows_;  ///< by vertex
  std::map<std::pair<Vertex, Vertex>, double> undercut_;
  double all_undercut_ = 0.0;  ///< sum of those [s]
  double reach_ = 0.0;         ///< longest distance to a landmark [s]
  std::size_t prepared_ = 0;   ///< vertices
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_LANDMARKS_H
