#include "core/mapping/graph_thinning.h"

#include <map>

namespace place_memory::core {
namespace {

/// Of each node that is tied and no place, the place that it is tied to first: the nearest.
std::map<NodeIndex, NodeIndex> visitsOf(const ScanGraph& graph) {
  std::map<NodeIndex, NodeIndex> place_of;
  for (const Tie& tie : graph.ties()) {
    if (graph.node(tie.node).place == kNoPlace) place_of.emplace(tie.node, tie.place);
  }
  return place_of;
}

/// Odometry from the last node before that stays; none where that is too far back.
void follow(const std::vector<ScanNode>& all, const std::vector<char>& dropped, double longest,
            ScanNode& node) {
  while (node.before && dropped[*node.before]) {
    const ScanNode& gone = all[*node.before];
    node.motion = gone.motion * node.motion;
    node.motion_way += gone.motion_way;
    node.motion_turn += gone.motion_turn;
    node.before = gone.before;
    if (node.motion_way > longest) node.before.reset();
  }
}

}  // namespace

std::optional<std::vector<std::optional<NodeIndex>>> thin(ScanGraph& graph,
                                                          const ThinningOptions& options) {
  const std::vector<ScanNode>& all = graph.nodes();
  if (all.size() <= options.newest) return std::nullopt;
  std::vector<char> dropped(all.size(), 0);
  std::map<NodeIndex, std::size_t> visits;
  bool any = false;
  const std::map<NodeIndex, NodeIndex> place_of = visitsOf(graph);
  for (auto visit = place_of.rbegin(); visit != place_of.rend(); ++visit) {
    if (++visits[visit->second] <= options.visits) continue;
    if (visit->first + options.newest >= all.size()) continue;
    dropped[visit->first] = 1;
    any = true;
  }
  if (!any) return std::nullopt;
  std::vector<std::optional<NodeIndex>> now(all.size());
  std::vector<ScanNode> kept;
  for (NodeIndex at = 0; at < all.size(); ++at) {
    if (dropped[at]) continue;
    ScanNode node = all[at];
    follow(all, dropped, options.longest, node);
    if (node.before) node.before = now[*node.before];
    now[at] = kept.size();
    kept.push_back(node);
  }
  std::vector<Tie> ties;
  for (Tie tie : graph.ties()) {
    if (!now[tie.node] || !now[tie.place]) continue;
    tie.node = *now[tie.node];
    tie.place = *now[tie.place];
    ties.push_back(tie);
  }
  graph.assign(std::move(kept), std::move(ties), graph.errors());
  return now;
}

}  // namespace place_memory::core
