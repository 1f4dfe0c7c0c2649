#ifndef PLACE_MEMORY_CORE_ROUTE_ROUTE_SEARCH_H
#define PLACE_MEMORY_CORE_ROUTE_ROUTE_SEARCH_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/route/landmarks.h"
#include "core/route/route_graph.h"

namespace place_memory::core {

/// The cheapest way from one vertex to another (Hart, Nilsson and Raphael 1968, A*). It works on
/// the graph as it lies and keeps its tables from one search to the next.
class RouteSearch {
 public:
  using Vertex = RouteGraph::Vertex;
  using Way = std::vector<Vertex>;  ///< from start to goal
  using Ends = std::pair<Vertex, Vertex>;

  struct Limits {
    std::vector<Ends> barred;  ///< arcs that are out of the question
    /// Where given, ways are compared by the number of links that they share with this one first.
    const Way* shunned = nullptr;
  };

  /// Nothing where there is no way. `landmarks` may be empty: it is Dijkstra's search then.
  std::optional<Way> find(const RouteGraph& graph, const Landmarks& landmarks, Vertex from,
                          Vertex to, const Limits& limits);
  /// Vertices that the newest search went on from.
  std::size_t expanded() const { return expanded_; }

 private:
  struct Node {
    double cost = 0.0;
    float left = 0.0F;  ///< bound of what is left
    Vertex before = RouteGraph::kNoVertex;
    std::uint32_t search = 0;  ///< in which it was seen
  };
  struct Open {
    double estimate;
    double cost;
    Vertex vertex;
    bool operator<(const Open& other) const { return estimate > other.estimate; }
  };

  void begin(std::size_t vertices);
  double extraCost(const Limits& limits, Vertex from, Vertex to) const;
  Way wayTo(Vertex goal) const;

  std::vector<Node> nodes_;
  std::vector<Open> open_;
  std::uint32_t search_ = 0;
  std::unordered_map<Vertex, std::size_t> shunned_at_;
  std::size_t expanded_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_ROUTE_SEARCH_H
