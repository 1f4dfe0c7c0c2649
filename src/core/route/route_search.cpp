#include "core/route/route_search.h"

#include <algorithm>
#include <limits>

namespace place_memory::core {
namespace {

// More than any way costs [s], and little enough that seconds are not rounded off beside it.
constexpr double kSharedLink = 1e9;

}  // namespace

void RouteSearch::begin(std::size_t vertices) {
  nodes_.resize(vertices);
  if (++search_ == 0) {  // after four thousand million searches
    for (Node& node : nodes_) node.search = 0;
    search_ = 1;
  }
  open_.clear();
  shunned_at_.clear();
  expanded_ = 0;
}

double RouteSearch::extraCost(const Limits& limits, Vertex from, Vertex to) const {
  for (const Ends& barred : limits.barred) {
    if (barred.first == from && barred.second == to) return std::numeric_limits<double>::infinity();
  }
  if (limits.shunned == nullptr) return 0.0;
  const auto one = shunned_at_.find(from), other = shunned_at_.find(to);
  if (one == shunned_at_.end() || other == shunned_at_.end()) return 0.0;
  const bool is_shared = one->second + 1 == other->second || other->second + 1 == one->second;
  return is_shared ? kSharedLink : 0.0;
}

RouteSearch::Way RouteSearch::wayTo(Vertex goal) const {
  Way way;
  for (Vertex at = goal; at != RouteGraph::kNoVertex; at = nodes_[at].before) way.push_back(at);
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<RouteSearch::Way> RouteSearch::find(const RouteGraph& graph,
                                                  const Landmarks& landmarks, Vertex from,
                                                  Vertex to, const Limits& limits) {
  begin(graph.size());
  if (limits.shunned != nullptr) {
    for (std::size_t i = 0; i < limits.shunned->size(); ++i) shunned_at_[(*limits.shunned)[i]] = i;
  }
  const bool is_limited = !limits.barred.empty() || limits.shunned != nullptr;
  const bool has_bounds = !landmarks.empty();
  const auto left = [&](Vertex vertex) {
    return has_bounds ? static_cast<float>(landmarks.bound(vertex, to)) : 0.0F;
  };
  nodes_[from] = {0.0, left(from), RouteGraph::kNoVertex, search_};
  open_.push_back({static_cast<double>(nodes_[from].left), 0.0, from});
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end());
    const Open next = open_.back();
    open_.pop_back();
    if (next.cost > nodes_[next.vertex].cost) continue;  // a cheaper way there was found since
    if (next.vertex == to) return wayTo(to);
    ++expanded_;
    for (const RouteGraph::Arc& arc : graph.arcs(next.vertex)) {
      if (arc.cost == RouteGraph::kBarred) continue;
      double cost = next.cost + static_cast<double>(arc.cost);
      if (is_limited) cost += extraCost(limits, next.vertex, arc.to);
      if (cost == std::numeric_limits<double>::infinity()) continue;
      Node& node = nodes_[arc.to];
      const bool is_known = node.search == search_;
      // Bounds less what links undercut may grow along a link by more than it costs, so that a
      // vertex is gone on from again where a cheaper way to it turns up.
      if (is_known && cost >= node.cost) continue;
      const float bound = is_known ? node.left : left(arc.to);
      node = {cost, bound, next.vertex, search_};
      open_.push_back({cost + static_cast<double>(bound), cost, arc.to});
      std::push_heap(open_.begin(), open_.end());
    }
  }
  return std::nullopt;
}

}  // namespace place_memory::core
