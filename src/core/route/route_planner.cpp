#include "core/route/route_planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/map/link_odds.h"
#include "core/route/no_route.h"

namespace place_memory::core {
namespace {

const LinkLearningOptions& checked(const LinkLearningOptions& options) {
  // Written so that NaN fails.
  if (!(options.half_life > 0.0)) throw std::invalid_argument("routes half_life must be above 0");
  if (!(options.speed > 0.0)) throw std::invalid_argument("routes speed must be above 0");
  return options;
}

std::size_t sharedLinks(const std::vector<PlaceId>& one, const std::vector<PlaceId>& other) {
  std::size_t shared = 0;
  for (std::size_t i = 1; i < one.size(); ++i) {
    for (std::size_t j = 1; j < other.size(); ++j) {
      if (std::minmax(one[i - 1], one[i]) == std::minmax(other[j - 1], other[j])) ++shared;
    }
  }
  return shared;
}

}  // namespace

RoutePlanner::RoutePlanner(const PlaceMap& map, const LinkLearningOptions& options)
    : map_(map), graph_(checked(options)) {
  graph_.build(map_);
}

void RoutePlanner::remember(const std::vector<Traversal>& traversals) {
  for (const Traversal& traversal : traversals) graph_.remember(traversal);
}

void RoutePlanner::follow(const MapChange& change) {
  graph_.follow(change, map_);
  landmarks_.follow(change, graph_, map_);
}

double RoutePlanner::odds(const PlaceLink& link, const LinkDirection& direction,
                          std::chrono::nanoseconds now) const {
  if (direction.forbidden) return 0.0;
  return graph_.odds(link, direction, now);
}

std::optional<RoutePlanner::Way> RoutePlanner::search(PlaceId from, PlaceId to,
                                                      const RouteSearch::Limits& limits) {
  return search_.find(graph_, landmarks_, graph_.vertexOf(from), graph_.vertexOf(to), limits);
}

Route RoutePlanner::routeOf(const Way& way, std::chrono::nanoseconds now) const {
  Route route;
  double variance = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    route.places.push_back(graph_.idOf(way[i]));
    if (i == 0) continue;
    const PlaceId from = route.places[i - 1], to = route.places[i];
    const PlaceLink& link = *map_.findLink(from, to);
    const LinkDirection& direction = from == link.first ? link.forward : link.backward;
    const double time = expectedTime(link, direction, graph_.options());
    const double through = odds(link, direction, now);
    route.time += time;
    variance += direction.time_sigma * direction.time_sigma;
    route.odds *= through;
    route.cost += time + direction.toll + (1.0 / through - 1.0) * expectedLoss(direction, time);
  }
  route.time_sigma = std::sqrt(variance);
  return route;
}

void RoutePlanner::addSecond(const Way& best, const RouteSearch::Limits& limits,
                             RouteAnswer& answer) {
  RouteSearch::Limits other = limits;
  other.shunned = &best;
  const std::optional<Way> way = search_.find(graph_, landmarks_, best.front(), best.back(), other);
  if (!way || *way == best) return;
  answer.second = routeOf(*way, now_);
  answer.shared_links = sharedLinks(answer.best.places, answer.second->places);
}

RouteAnswer RoutePlanner::plan(const RouteRequest& request, std::chrono::nanoseconds now) {
  RouteAnswer answer;
  now_ = now;
  if (map_.find(request.goal) == nullptr) {
    answer.status = RouteAnswer::Status::kUnknownGoal;
    answer.reason = "there is no place " + std::to_string(request.goal) + " to go to";
    return answer;
  }
  std::vector<RouteStart> starts;
  for (const RouteStart& start : request.starts) {
    if (map_.find(start.place) != nullptr && start.probability > 0.0) starts.push_back(start);
  }
  if (starts.empty()) {
    answer.status = RouteAnswer::Status::kUnknownStart;
    answer.reason = "there is no such place to start from";
    return answer;
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const RouteStart& one, const RouteStart& other) {
                     return one.probability > other.probability;
                   });
  graph_.refresh(map_, now);
  if (map_.size() > kPreparedFrom && (landmarks_.empty() || landmarks_.areWorn())) {
    landmarks_.prepare(graph_, map_);
  }
  RouteSearch::Limits limits;
  for (const auto& [from, to] : request.avoided) {
    limits.barred.emplace_back(graph_.vertexOf(from), graph_.vertexOf(to));
  }
  double weighed = 0.0, all = 0.0, led = 0.0;
  std::optional<Way> best;
  for (const RouteStart& start : starts) {
    all += start.probability;
    const std::optional<Way> way = search(start.place, request.goal, limits);
    if (!way) {
      if (answer.reason.empty()) {
        answer.reason = whyNoRoute(map_, graph_, start.place, request.goal);
      }
      continue;
    }
    const Route route = routeOf(*way, now);
    led += start.probability;
    weighed += start.probability * route.cost;
    if (best) continue;
    best = way;
    answer.best = route;
  }
  answer.stranded = 1.0 - led / all;
  if (!best) return answer;
  answer.status = RouteAnswer::Status::kFound;
  answer.reason.clear();
  answer.expected_cost = weighed / led;
  if (request.second && best->size() > 1) addSecond(*best, limits, answer);
  return answer;
}

}  // namespace place_memory::core
