#include "core/route/no_route.h"

#include <cstddef>
#include <vector>

namespace place_memory::core {
namespace {

using Vertex = RouteGraph::Vertex;

std::string called(const PlaceMap& map, PlaceId id) {
  const Place* place = map.find(id);
  return place == nullptr ? "place " + std::to_string(id) : "\"" + place->label + "\"";
}

/// Every place that links lead to, whatever they cost, and where it was come from.
class Island {
 public:
  Island(const RouteGraph& graph, Vertex from)
      : before_(graph.size(), RouteGraph::kNoVertex), places_{from} {
    before_[from] = from;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      for (const RouteGraph::Arc& arc : graph.arcs(places_[i])) {
        if (before_[arc.to] != RouteGraph::kNoVertex) continue;
        before_[arc.to] = places_[i];
        places_.push_back(arc.to);
      }
    }
  }

  bool has(Vertex vertex) const { return before_[vertex] != RouteGraph::kNoVertex; }
  Vertex before(Vertex vertex) const { return before_[vertex]; }
  std::size_t size() const { return places_.size(); }

 private:
  std::vector<Vertex> before_;
  std::vector<Vertex> places_;
};

std::string inWords(std::size_t places) {
  return places == 1 ? "no other place" : std::to_string(places - 1) + " other places";
}

}  // namespace

std::string whyNoRoute(const PlaceMap& map, const RouteGraph& graph, PlaceId from, PlaceId to) {
  const Vertex start = graph.vertexOf(from), goal = graph.vertexOf(to);
  const Island here(graph, start);
  if (!here.has(goal)) {
    const Island there(graph, goal);
    return "no link joins where " + called(map, to) + " is, with " + inWords(there.size()) +
           ", to where " + called(map, from) + " is, with " + inWords(here.size()) +
           ": drive from one to the other while places are learned";
  }
  // Some link is in the way of every route: one of those on the way that looks shortest is named.
  for (Vertex at = goal; at != start; at = here.before(at)) {
    for (const RouteGraph::Arc& arc : graph.arcs(here.before(at))) {
      if (arc.to == at && arc.cost == RouteGraph::kBarred) {
        return "links that are forbidden bar every way, as the one from " +
               called(map, graph.idOf(here.before(at))) + " to " + called(map, graph.idOf(at)) +
               ": set_link unblocks them";
      }
    }
  }
  return "every way leads over a link that was just found blocked, and is not tried again for this "
         "goal";
}

}  // namespace place_memory::core
