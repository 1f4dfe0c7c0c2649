#ifndef PLACE_MEMORY_CORE_ROUTE_ROUTE_GRAPH_H
#define PLACE_MEMORY_CORE_ROUTE_ROUTE_GRAPH_H

#include <boost/container/small_vector.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "core/map/link_hours.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What the links of a map cost each way, laid out for a search: 56 bytes a place. It follows the
/// map change by change; times, odds and poses stay in the map alone.
class RouteGraph {
 public:
  /// Numbers a place; not given again before the map is cleared.
  using Vertex = std::uint32_t;
  static constexpr Vertex kNoVertex = std::numeric_limits<Vertex>::max();
  static constexpr float kBarred = std::numeric_limits<float>::infinity();

  struct Arc {
    Vertex to = kNoVertex;
    float cost = 0.0F;  ///< [s]; kBarred: forbidden
  };
  using Arcs = boost::container::small_vector<Arc, 4>;

  explicit RouteGraph(const LinkLearningOptions& options)
      : options_(options), hours_(options.half_life) {}

  /// Takes the map as it is, of whose links nothing is known at which hours they are open; costs
  /// wait for refresh().
  void build(const PlaceMap& map);
  /// A traversal of earlier than whatever follow() tells, the oldest first.
  void remember(const Traversal& traversal) { hours_.note(traversal); }
  /// After the map has made the change.
  void follow(const MapChange& change, const PlaceMap& map);
  /// Costs as they are at `now`. All are computed anew once evidence has aged by more than a
  /// percent or more than a 64th of the links have learned since, or another hour began where hours
  /// count; of others those that learned are.
  void refresh(const PlaceMap& map, std::chrono::nanoseconds now);

  /// Of all vertices, also of places that are gone.
  std::size_t size() const { return arcs_.size(); }
  /// kNoVertex: there is no such place.
  Vertex vertexOf(PlaceId id) const;
  PlaceId idOf(Vertex vertex) const { return ids_[vertex]; }
  const Arcs& arcs(Vertex vertex) const { return arcs_[vertex]; }

  const LinkLearningOptions& options() const { return options_; }
  /// Of going along a link at `now` that is not forbidden, in [kLeastOdds, 1).
  double odds(const PlaceLink& link, const LinkDirection& direction,
              std::chrono::nanoseconds now) const;
  /// Least that the link can ever cost, either way, as its times are known now [s].
  double leastCost(const PlaceLink& link) const;

 private:
  friend class RouteGraphEditor;

  Vertex addVertex(PlaceId id);
  void removeVertex(PlaceId id);
  void setLink(const PlaceLink& link);
  void removeLink(PlaceId one, PlaceId other);
  void setArc(Vertex from, Vertex to, double cost);
  void removeArc(Vertex from, Vertex to);
  double costOf(const PlaceLink& link, const LinkDirection& direction) const;

  LinkLearningOptions options_;
  LinkHours hours_;
  std::unordered_map<PlaceId, Vertex> vertices_;
  std::vector<PlaceId> ids_;
  std::vector<Arcs> arcs_;
  std::size_t links_ = 0;
  std::size_t changed_ = 0;  ///< links since all costs were computed
  bool is_fresh_ = false;    ///< costs were computed since build()
  std::chrono::nanoseconds costed_{0};
  double caution_ = 1.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_ROUTE_GRAPH_H
