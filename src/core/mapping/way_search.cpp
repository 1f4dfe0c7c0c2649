#include "core/mapping/way_search.h"

#include <algorithm>

namespace place_memory::core {

WaySearch::WaySearch(const ScanGraph& graph, NodeIndex from, double radius)
    : graph_(graph), radius_(radius) {
  open_.push({0.0, from});
  best_[from] = {0.0, from};
}

std::optional<double> WaySearch::to(NodeIndex node) {
  while (true) {
    const auto found = settled_.find(node);
    if (found != settled_.end()) return found->second;
    if (open_.empty()) return std::nullopt;
    expand();
  }
}

std::vector<NodeIndex> WaySearch::along(NodeIndex node) const {
  std::vector<NodeIndex> way{node};
  for (const Reached* at = &best_.at(node); at->way > 0.0; at = &best_.at(at->before)) {
    way.push_back(at->before);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

void WaySearch::expand() {
  const auto [way, at] = open_.top();
  open_.pop();
  if (!settled_.emplace(at, way).second) return;
  graph_.steps(at, steps_);
  for (const ScanGraph::Step& step : steps_) {
    const double further = way + step.way;
    if (further > radius_) continue;
    const auto [found, is_new] = best_.emplace(step.to, Reached{further, at});
    if (!is_new && found->second.way <= further) continue;
    found->second = {further, at};
    open_.push({further, step.to});
  }
}

}  // namespace place_memory::core
