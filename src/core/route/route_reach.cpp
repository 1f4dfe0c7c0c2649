#include "core/route/route_reach.h"

#include <functional>
#include <queue>
#include <tuple>
#include <unordered_set>

namespace place_memory::core {

std::vector<ReachedPlace> reachedFrom(const RouteGraph& graph, PlaceId from, double most_time) {
  using Vertex = RouteGraph::Vertex;
  using Open = std::tuple<double, Vertex, Vertex>;  // time, vertex, the one before
  std::vector<ReachedPlace> reached;
  if (graph.vertexOf(from) == RouteGraph::kNoVertex) return reached;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::unordered_set<Vertex> done;
  open.emplace(0.0, graph.vertexOf(from), RouteGraph::kNoVertex);
  while (!open.empty()) {
    const auto [time, vertex, before] = open.top();
    open.pop();
    if (!done.insert(vertex).second) continue;
    reached.push_back({graph.idOf(vertex),
                       before == RouteGraph::kNoVertex ? kNoPlace : graph.idOf(before), time});
    for (const RouteGraph::Arc& arc : graph.arcs(vertex)) {
      const double there = time + static_cast<double>(arc.cost);
      if (there <= most_time && done.count(arc.to) == 0) open.emplace(there, arc.to, vertex);
    }
  }
  return reached;
}

}  // namespace place_memory::core
