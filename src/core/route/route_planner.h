#ifndef PLACE_MEMORY_CORE_ROUTE_ROUTE_PLANNER_H
#define PLACE_MEMORY_CORE_ROUTE_ROUTE_PLANNER_H

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/route/landmarks.h"
#include "core/route/route_graph.h"
#include "core/route/route_search.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/routes.h"

namespace place_memory::core {

/// Plans routes through a map that it follows change by change (ELDEN's adaptive topological path
/// planner, paper 10): by expected time of arrival, with what is to be feared of links weighed in.
///
/// Of a map with more than kPreparedFrom places distances to landmarks are prepared by the first
/// plan, and anew by the first one after much has changed. Not thread-safe.
class RoutePlanner {
 public:
  static constexpr std::size_t kPreparedFrom = 5000;

  /// `map` has to outlive the planner. Throws std::invalid_argument naming an option out of range.
  RoutePlanner(const PlaceMap& map, const LinkLearningOptions& options);

  /// What links learned of hours before: the map's own traversals, the oldest first.
  void remember(const std::vector<Traversal>& traversals);
  /// Right after the map has made the change.
  void follow(const MapChange& change);

  /// What would be done at `now`. Places that are not there are an answer too.
  RouteAnswer plan(const RouteRequest& request, std::chrono::nanoseconds now);

  /// Of going along a link now, 0 where it is forbidden.
  double odds(const PlaceLink& link, const LinkDirection& direction,
              std::chrono::nanoseconds now) const;
  /// Places that the newest search went on from.
  std::size_t expanded() const { return search_.expanded(); }

 private:
  using Way = RouteSearch::Way;

  std::optional<Way> search(PlaceId from, PlaceId to, const RouteSearch::Limits& limits);
  void addSecond(const Way& best, const RouteSearch::Limits& limits, RouteAnswer& answer);
  Route routeOf(const Way& way, std::chrono::nanoseconds now) const;

  const PlaceMap& map_;
  RouteGraph graph_;
  Landmarks landmarks_;
  RouteSearch search_;
  std::chrono::nanoseconds now_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_ROUTE_PLANNER_H
