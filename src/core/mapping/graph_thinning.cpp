#include "core/mapping/graph_thinning.h"

#include <algorithm>
#include <map>
#include <utility>

namespace place_memory::core {
namespace {

using VisitedPlaces = std::map<NodeIndex, NodeIndex>;

/// Of each node that is tied to places and is none, the one that it is tied to first: the nearest.
VisitedPlaces visitsOf(const ScanGraph& graph) {
  VisitedPlaces place_of;
  for (const Tie& tie : graph.ties()) {
    const bool of_place = graph.node(tie.place).place != kNoPlace;
    if (of_place && graph.node(tie.node).place == kNoPlace) place_of.emplace(tie.node, tie.place);
  }
  return place_of;
}

/// All but the newest visits of each place. Returns whether there were any.
bool dropVisits(const VisitedPlaces& place_of, std::size_t kept, NodeIndex newest,
                std::vector<char>& dropped) {
  std::map<NodeIndex, std::size_t> visits;
  bool any = false;
  for (auto visit = place_of.rbegin(); visit != place_of.rend(); ++visit) {
    if (++visits[visit->second] <= kept || visit->first >= newest) continue;
    dropped[visit->first] = 1;
    any = true;
  }
  return any;
}

/// The nodes from `first` up to `last`, without it, are tied to nothing; those before and after are
/// about these two places, the lower index first. A way that begins or ends where odometry does has
/// one place twice.
struct UntiedWay {
  NodeIndex first;
  NodeIndex last;
  std::pair<NodeIndex, NodeIndex> places;
};

std::vector<UntiedWay> untiedWays(const ScanGraph& graph, const VisitedPlaces& place_of) {
  std::vector<UntiedWay> ways;
  NodeIndex first = 0;
  std::optional<NodeIndex> before;  // place about which the way began
  const auto end = [&](NodeIndex last, std::optional<NodeIndex> after) {
    if (last > first && (before || after)) {
      ways.push_back(
          {first, last, std::minmax(before ? *before : *after, after ? *after : *before)});
    }
    before = after;
  };
  for (NodeIndex at = 0; at < graph.nodes().size(); ++at) {
    const ScanNode& node = graph.node(at);
    if (at > 0 && node.before != at - 1) {
      end(at, std::nullopt);
      first = at;
    }
    const auto tied = place_of.find(at);
    if (node.place == kNoPlace && tied == place_of.end()) continue;
    end(at, node.place != kNoPlace ? at : tied->second);
    first = at + 1;
  }
  return ways;
}

/// All but the newest ways between each two places, likewise.
bool dropUntied(const std::vector<UntiedWay>& ways, std::size_t kept, NodeIndex newest,
                std::vector<char>& dropped) {
  std::map<std::pair<NodeIndex, NodeIndex>, std::size_t> driven;
  bool any = false;
  for (auto way = ways.rbegin(); way != ways.rend(); ++way) {
    if (++driven[way->places] <= kept || way->last > newest) continue;
    std::fill(dropped.begin() + static_cast<std::ptrdiff_t>(way->first),
              dropped.begin() + static_cast<std::ptrdiff_t>(way->last), 1);
    any = true;
  }
  return any;
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
  const NodeIndex newest = all.size() - options.newest;
  const VisitedPlaces place_of = visitsOf(graph);
  const bool visits = dropVisits(place_of, options.visits, newest, dropped);
  const bool untied = dropUntied(untiedWays(graph, place_of), options.untied, newest, dropped);
  if (!visits && !untied) return std::nullopt;
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
