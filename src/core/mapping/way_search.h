#ifndef PLACE_MEMORY_CORE_MAPPING_WAY_SEARCH_H
#define PLACE_MEMORY_CORE_MAPPING_WAY_SEARCH_H

#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/mapping/scan_graph.h"

namespace place_memory::core {

constexpr double kFarthestWay = 80.0;  ///< that is worth following [m]

/// Lengths of the shortest ways through the graph from one node (Dijkstra 1959), worked out no
/// further than is asked for: what is near costs little, however large the map.
class WaySearch {
 public:
  /// Keeps a reference. No further than `radius` [m].
  WaySearch(const ScanGraph& graph, NodeIndex from, double radius);

  /// Length of the shortest way to a node [m]; nothing where it is too far, or there is none.
  std::optional<double> to(NodeIndex node);
  /// The nodes of that way, from its beginning to `node`; `to(node)` is something.
  std::vector<NodeIndex> along(NodeIndex node) const;

 private:
  using Entry = std::pair<double, NodeIndex>;

  void expand();

  const ScanGraph& graph_;
  double radius_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  struct Reached {
    double way;
    NodeIndex before;
  };
  std::unordered_map<NodeIndex, Reached> best_;
  std::unordered_map<NodeIndex, double> settled_;
  std::vector<ScanGraph::Step> steps_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_WAY_SEARCH_H
