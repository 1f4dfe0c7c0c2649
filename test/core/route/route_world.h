#ifndef PLACE_MEMORY_TEST_CORE_ROUTE_ROUTE_WORLD_H
#define PLACE_MEMORY_TEST_CORE_ROUTE_ROUTE_WORLD_H

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/map/link_odds.h"
#include "core/route/route_planner.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {

inline PlaceAdded placeAt(PlaceId id, double x, double y) {
  PlaceAdded edit;
  edit.place.id = id;
  edit.place.label = "p" + std::to_string(id);
  edit.place.map_from_place = {x, y, 0.0};
  return edit;
}

/// `time`: that it takes either way [s], as it was timed.
inline LinkAdded linkOf(PlaceId one, PlaceId other, double time) {
  PlaceLink link;
  link.first = std::min(one, other);
  link.second = std::max(one, other);
  link.first_from_second = {1.0, 0.0, 0.0};
  link.forward.time = time;
  link.backward.time = time;
  return {link};
}

/// A map and a planner that follows it.
class RouteWorld {
 public:
  explicit RouteWorld(const LinkLearningOptions& options = {})
      : options_(options), planner_(map_, options) {}

  void change(std::vector<MapEdit> edits) {
    const MapChange change{map_.version() + 1, std::chrono::nanoseconds(0), std::move(edits)};
    map_.apply(change);
    planner_.follow(change);
  }

  RouteAnswer plan(PlaceId from, PlaceId to, bool second = false) {
    RouteRequest request;
    request.starts = {{from, 1.0}};
    request.goal = to;
    request.second = second;
    return planner_.plan(request, now_);
  }

  /// What a step costs by itself, infinite where it is forbidden.
  double cost(PlaceId from, PlaceId to) const {
    const PlaceLink& link = *map_.findLink(from, to);
    const LinkDirection& direction = from == link.first ? link.forward : link.backward;
    if (direction.forbidden) return std::numeric_limits<double>::infinity();
    const double time = expectedTime(link, direction, options_);
    const double through = planner_.odds(link, direction, now_);
    return time + direction.toll + (1.0 / through - 1.0) * expectedLoss(direction, time);
  }

  /// Of the cheapest way, by going over all links again and again (Bellman and Ford).
  double leastCost(PlaceId from, PlaceId to) const {
    std::map<PlaceId, double> costs;
    for (const Place& place : map_.places()) costs[place.id] = INFINITY;
    costs[from] = 0.0;
    const std::vector<PlaceLink> links = map_.links();
    for (bool changed = true; changed;) {
      changed = false;
      for (const PlaceLink& link : links) {
        for (const auto& [a, b] :
             {std::pair{link.first, link.second}, std::pair{link.second, link.first}}) {
          const double further = costs[a] + cost(a, b);
          if (further >= costs[b] - 1e-12) continue;
          costs[b] = further;
          changed = true;
        }
      }
    }
    return costs[to];
  }

  const PlaceMap& map() const { return map_; }
  RoutePlanner& planner() { return planner_; }
  void setNow(std::chrono::nanoseconds now) { now_ = now; }

 private:
  LinkLearningOptions options_;
  PlaceMap map_;
  RoutePlanner planner_;
  std::chrono::nanoseconds now_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_ROUTE_ROUTE_WORLD_H
