#include "core/mapping/way_search.h"

namespace place_memory::core {

WaySearch::WaySearch(const ScanGraph& graph, NodeIndex from, double radius)
    : graph_(graph), radius_(radius) {
  open_.push({0.0, from});
  best_[from] = 0.0;
}

std::optional<double> WaySearch::to(NodeIndex node) {
  while (true) {
    const auto found = settled_.find(node);
    if (found != settled_.end()) return found->second;
    if (open_.empty()) return std::nullopt;
    expand();
  }
}

void WaySearch::expand() {
  const auto [way, at] = open_.top();
  open_.pop();
  if (!settled_.emplace(at, way).second) return;
  graph_.steps(at, steps_);
  for (const ScanGraph::Step& step : steps_) {
    const double further = way + step.way;
    if (further > radius_) continue;
    const auto [found, is_new] = best_.emplace(step.to, further);
    if (!is_new && found->second <= further) continue;
    found->second = further;
    open_.push({further, step.to});
  }
}

}  // namespace place_memory::core
