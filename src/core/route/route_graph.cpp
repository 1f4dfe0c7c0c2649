#include "core/route/route_graph.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/map/link_odds.h"

namespace place_memory::core {
namespace {

// Share of the half-life, and of the links, after which all costs are computed anew.
constexpr double kStaleShare = 1.0 / 64.0;

}  // namespace

/// Makes the edits of a change in the graph.
class RouteGraphEditor {
 public:
  RouteGraphEditor(RouteGraph& graph, const PlaceMap& map) : graph_(graph), map_(map) {}

  void operator()(const PlaceAdded& edit) { graph_.addVertex(edit.place.id); }
  void operator()(const PlaceRemoved& edit) { graph_.removeVertex(edit.id); }
  void operator()(const LinkAdded& edit) { graph_.setLink(edit.link); }
  void operator()(const LinkRemoved& edit) { graph_.removeLink(edit.first, edit.second); }
  void operator()(const LinkLearned& edit) {
    if (edit.traversal) graph_.hours_.note(*edit.traversal);
    // Where it is gone by the end of the change, the edit that takes it out comes later.
    const PlaceLink* link = map_.findLink(edit.from, edit.to);
    if (link != nullptr) graph_.setLink(*link);
  }
  void operator()(const MapCleared& /*edit*/) { graph_ = RouteGraph(graph_.options_); }
  void operator()(const PlaceMoved& /*edit*/) {}
  void operator()(const PlaceRenamed& /*edit*/) {}
  void operator()(const GridAdapted& /*edit*/) {}

 private:
  RouteGraph& graph_;
  const PlaceMap& map_;
};

void RouteGraph::build(const PlaceMap& map) {
  *this = RouteGraph(options_);
  vertices_.reserve(map.size());
  ids_.reserve(map.size());
  arcs_.reserve(map.size());
  for (const Place& place : map.places()) addVertex(place.id);
  map.forEachLink([this](const PlaceLink& link) { setLink(link); });
}

void RouteGraph::follow(const MapChange& change, const PlaceMap& map) {
  RouteGraphEditor editor(*this, map);
  for (const MapEdit& edit : change.edits) std::visit(editor, edit);
}

void RouteGraph::refresh(const PlaceMap& map, std::chrono::nanoseconds now) {
  const double aged = std::abs(std::chrono::duration<double>(now - costed_).count());
  const bool is_other_hour = LinkHours::hourOf(now) != LinkHours::hourOf(costed_);
  const bool is_stale = (is_other_hour && hours_.any()) ||
                        aged > kStaleShare * options_.half_life ||
                        static_cast<double>(changed_) > kStaleShare * static_cast<double>(links_);
  if (is_fresh_ && !is_stale) return;
  is_fresh_ = true;
  costed_ = now;
  MapCaution caution;
  map.forEachLink([&](const PlaceLink& link) {
    caution.add(link.forward, now, options_.half_life);
    caution.add(link.backward, now, options_.half_life);
  });
  caution_ = caution.value();
  map.forEachLink([this](const PlaceLink& link) { setLink(link); });
  changed_ = 0;
}

RouteGraph::Vertex RouteGraph::vertexOf(PlaceId id) const {
  const auto found = vertices_.find(id);
  return found == vertices_.end() ? kNoVertex : found->second;
}

double RouteGraph::leastCost(const PlaceLink& link) const {
  return std::min(expectedTime(link, link.forward, options_) + link.forward.toll,
                  expectedTime(link, link.backward, options_) + link.backward.toll);
}

RouteGraph::Vertex RouteGraph::addVertex(PlaceId id) {
  const auto vertex = static_cast<Vertex>(ids_.size());
  vertices_[id] = vertex;
  ids_.push_back(id);
  arcs_.emplace_back();
  return vertex;
}

void RouteGraph::removeVertex(PlaceId id) {
  const Vertex vertex = vertexOf(id);
  if (vertex == kNoVertex) return;
  for (const Arc& arc : arcs_[vertex]) {
    removeArc(arc.to, vertex);
    hours_.forget(id, ids_[arc.to]);
    --links_;
  }
  arcs_[vertex].clear();
  ids_[vertex] = kNoPlace;
  vertices_.erase(id);
}

void RouteGraph::setLink(const PlaceLink& link) {
  const Vertex first = vertexOf(link.first), second = vertexOf(link.second);
  if (first == kNoVertex || second == kNoVertex) return;
  const std::size_t before = arcs_[first].size();
  setArc(first, second, costOf(link, link.forward));
  setArc(second, first, costOf(link, link.backward));
  links_ += arcs_[first].size() - before;
  ++changed_;
}

void RouteGraph::removeLink(PlaceId one, PlaceId other) {
  const Vertex first = vertexOf(one), second = vertexOf(other);
  if (first == kNoVertex || second == kNoVertex) return;
  removeArc(first, second);
  removeArc(second, first);
  hours_.forget(one, other);
  --links_;
}

void RouteGraph::setArc(Vertex from, Vertex to, double cost) {
  Arcs& arcs = arcs_[from];
  const auto found =
      std::find_if(arcs.begin(), arcs.end(), [to](const Arc& arc) { return arc.to == to; });
  if (found == arcs.end()) {
    arcs.push_back({to, static_cast<float>(cost)});
  } else {
    found->cost = static_cast<float>(cost);
  }
}

void RouteGraph::removeArc(Vertex from, Vertex to) {
  Arcs& arcs = arcs_[from];
  arcs.erase(
      std::remove_if(arcs.begin(), arcs.end(), [to](const Arc& arc) { return arc.to == to; }),
      arcs.end());
}

double RouteGraph::costOf(const PlaceLink& link, const LinkDirection& direction) const {
  if (direction.forbidden) return kBarred;
  const double time = expectedTime(link, direction, options_);
  return time + direction.toll +
         (1.0 / odds(link, direction, costed_) - 1.0) * expectedLoss(direction, time);
}

double RouteGraph::odds(const PlaceLink& link, const LinkDirection& direction,
                        std::chrono::nanoseconds now) const {
  const double plain = oddsThrough(direction, wasDriven(link), caution_, now, options_.half_life);
  return hours_.weighed(link, plain, now);
}

}  // namespace place_memory::core
