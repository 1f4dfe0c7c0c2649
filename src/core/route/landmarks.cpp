#include "core/route/landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <variant>

namespace place_memory::core {
namespace {

using Vertex = RouteGraph::Vertex;

// Links may become so much quicker before they undercut the bounds: times are learned.
constexpr double kSlack = 0.985;
// Of the reach, that all links together may undercut.
constexpr double kWornUndercut = 0.02;
constexpr double kWornGrowth = 1.25;

/// The map's links with their least costs, for many searches of the whole.
class LeastGraph {
 public:
  LeastGraph(const RouteGraph& graph, const PlaceMap& map) : first_(graph.size() + 1, 0) {
    const auto ends = [&](const PlaceLink& link) {
      return std::make_pair(graph.vertexOf(link.first), graph.vertexOf(link.second));
    };
    map.forEachLink([&](const PlaceLink& link) {
      const auto [one, other] = ends(link);
      ++first_[one + 1];
      ++first_[other + 1];
    });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    arcs_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    map.forEachLink([&](const PlaceLink& link) {
      const auto [one, other] = ends(link);
      const auto least = static_cast<float>(kSlack * graph.leastCost(link));
      arcs_[next[one]++] = {other, least};
      arcs_[next[other]++] = {one, least};
    });
  }

  std::vector<float> distancesFrom(Vertex source) const {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    std::vector<float> distances(first_.size() - 1, kFar);
    using Item = std::pair<float, Vertex>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    distances[source] = 0.0F;
    open.emplace(0.0F, source);
    while (!open.empty()) {
      const auto [distance, vertex] = open.top();
      open.pop();
      if (distance > distances[vertex]) continue;
      for (std::size_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
        const float further = distance + arcs_[i].cost;
        if (further >= distances[arcs_[i].to]) continue;
        distances[arcs_[i].to] = further;
        open.emplace(further, arcs_[i].to);
      }
    }
    return distances;
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<RouteGraph::Arc> arcs_;
};

/// A vertex of the largest island, or nearly: the one that has most in reach of some tries.
Vertex anyVertex(const RouteGraph& graph, const LeastGraph& least) {
  Vertex best = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto vertex = static_cast<Vertex>(graph.size() * (2 * i + 1) / 8);
    const std::vector<float> distances = least.distancesFrom(vertex);
    const auto reached = static_cast<std::size_t>(
        std::count_if(distances.begin(), distances.end(),
                      [](float distance) { return std::isfinite(distance); }));
    if (reached > most) best = vertex;
    most = std::max(most, reached);
    if (2 * reached > graph.size()) break;
  }
  return best;
}

Vertex farthest(const std::vector<float>& distances) {
  Vertex best = 0;
  float most = -1.0F;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (!std::isfinite(distances[i]) || distances[i] <= most) continue;
    most = distances[i];
    best = static_cast<Vertex>(i);
  }
  return best;
}

}  // namespace

Landmarks::Row Landmarks::noWay() {
  Row row;
  row.fill(std::numeric_limits<float>::quiet_NaN());
  return row;
}

bool Landmarks::isOff(Vertex vertex) const { return std::isnan(rows_[vertex].front()); }

void Landmarks::prepare(const RouteGraph& graph, const PlaceMap& map) {
  clear();
  if (graph.size() == 0) return;
  const LeastGraph least(graph, map);
  rows_.assign(graph.size(), noWay());
  prepared_ = graph.size();
  // Each as far as can be from those before.
  std::vector<float> nearest = least.distancesFrom(anyVertex(graph, least));
  for (std::size_t k = 0; k < kLandmarks; ++k) {
    const std::vector<float> distances = least.distancesFrom(farthest(nearest));
    for (std::size_t i = 0; i < distances.size(); ++i) {
      if (!std::isfinite(distances[i])) continue;
      rows_[i][k] = distances[i];
      reach_ = std::max(reach_, static_cast<double>(distances[i]));
      nearest[i] = k == 0 ? distances[i] : std::min(nearest[i], distances[i]);
    }
  }
}

void Landmarks::follow(const MapChange& change, const RouteGraph& graph, const PlaceMap& map) {
  if (empty()) return;
  for (const MapEdit& edit : change.edits) {
    if (std::holds_alternative<MapCleared>(edit)) return clear();
  }
  rows_.resize(graph.size(), noWay());
  const auto look = [&](PlaceId first, PlaceId second) {
    const Vertex one = graph.vertexOf(first), other = graph.vertexOf(second);
    if (one == RouteGraph::kNoVertex || other == RouteGraph::kNoVertex) return;
    const PlaceLink* link = map.findLink(first, second);
    if (link == nullptr) {
      linkIsGone(one, other);
    } else if (isOff(one) != isOff(other)) {
      join(isOff(one) ? one : other, rows_[isOff(one) ? other : one], graph, map);
    } else if (!isOff(one)) {
      linkIs(one, other, graph.leastCost(*link));
    }
  };
  for (const MapEdit& edit : change.edits) {
    if (const auto* added = std::get_if<LinkAdded>(&edit)) {
      look(added->link.first, added->link.second);
    } else if (const auto* learned = std::get_if<LinkLearned>(&edit)) {
      look(learned->from, learned->to);
    } else if (const auto* removed = std::get_if<LinkRemoved>(&edit)) {
      look(removed->first, removed->second);
    }
  }
}

// Of places that come to the landmarks' island nothing is known but that they lie near one of it.
void Landmarks::join(Vertex vertex, const Row& near, const RouteGraph& graph, const PlaceMap& map) {
  const Row row = near;
  std::vector<Vertex> joined{vertex};
  rows_[vertex] = row;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    for (const RouteGraph::Arc& arc : graph.arcs(joined[i])) {
      if (isOff(arc.to)) {
        rows_[arc.to] = row;
        joined.push_back(arc.to);
      } else {
        const PlaceLink* link = map.findLink(graph.idOf(joined[i]), graph.idOf(arc.to));
        linkIs(joined[i], arc.to, graph.leastCost(*link));
      }
    }
  }
}

double Landmarks::gap(Vertex one, Vertex other) const {
  const Row& from = rows_[one];
  const Row& to = rows_[other];
  float most = 0.0F;
  for (std::size_t k = 0; k < kLandmarks; ++k) {
    const float apart = std::abs(from[k] - to[k]);
    most = apart > most ? apart : most;  // false of what is not a number
  }
  return static_cast<double>(most);
}

void Landmarks::linkIsGone(Vertex one, Vertex other) {
  const auto found = undercut_.find(std::minmax(one, other));
  if (found == undercut_.end()) return;
  all_undercut_ -= found->second;
  undercut_.erase(found);
}

void Landmarks::linkIs(Vertex one, Vertex other, double least) {
  linkIsGone(one, other);
  const double undercut = gap(one, other) - least;
  if (undercut <= 0.0) return;
  undercut_[std::minmax(one, other)] = undercut;
  all_undercut_ += undercut;
}

bool Landmarks::areWorn() const {
  return all_undercut_ > kWornUndercut * reach_ ||
         static_cast<double>(rows_.size()) > kWornGrowth * static_cast<double>(prepared_);
}

double Landmarks::bound(Vertex from, Vertex to) const {
  return std::max(gap(from, to) - all_undercut_, 0.0);
}

}  // namespace place_memory::core
