#ifndef PLACE_MEMORY_CORE_ROUTES_H
#define PLACE_MEMORY_CORE_ROUTES_H

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A way through the map, from place to place along links.
struct Route {
  std::vector<PlaceId> places;  ///< from the start to the goal; one where the robot is there
  /// Expected time until the robot is there [s]: over its links the time each takes, its toll, and
  /// (1 / odds - 1) times what an attempt costs that fails.
  double cost = 0.0;
  double time = 0.0;        ///< where every link is open [s]
  double time_sigma = 0.0;  ///< spread of that, as far as it was timed [s]
  double odds = 1.0;        ///< of getting through every link at the first attempt
};

/// A place where the robot may be.
struct RouteStart {
  PlaceId place = kNoPlace;
  double probability = 1.0;  ///< in (0, 1]
};

struct RouteRequest {
  std::vector<RouteStart> starts;  ///< at least one
  PlaceId goal = kNoPlace;
  /// Links, from and to, that are out of the question this time, as they were just found blocked.
  std::vector<std::pair<PlaceId, PlaceId>> avoided;
  bool second = true;  ///< whether a second route is wanted
};

/// A place, by the first of these that is given.
struct RouteEnd {
  PlaceId id = kNoPlace;
  std::string label;
  /// The place nearest to this spot of the map: of those of the session in which the robot is,
  /// where that is known.
  std::optional<Pose2d> pose;
};

/// What PlaceMemory is asked for.
struct RouteQuery {
  std::optional<RouteEnd> start;
  /// Where the robot may be, without a start; empty: where it was learned or recognized last.
  std::vector<RouteStart> starts;
  RouteEnd goal;
  std::vector<std::pair<PlaceId, PlaceId>> avoided;  ///< as of RouteRequest
  bool second = true;
};

/// What the planner says; without a route it is an answer too.
struct RouteAnswer {
  enum class Status {
    kFound,
    kNoRoute,       ///< no way leads there
    kNotLocalized,  ///< where the robot is, is not known
    kUnknownStart,
    kUnknownGoal,
  };
  Status status = Status::kNoRoute;
  std::string reason;  ///< why there is no route, in a sentence; "" where there is one
  Route best;          ///< from the likeliest start
  /// Over all starts that lead to the goal, weighed by their probabilities [s].
  double expected_cost = 0.0;
  double stranded = 0.0;  ///< share of the probability at starts from which no way leads there
  /// Of the other routes from there one that shares the fewest links, and of these the quickest;
  /// nothing where there is no other one.
  std::optional<Route> second;
  std::size_t shared_links = 0;  ///< that `second` has in common with `best`
};

/// What PlaceMemory answers.
struct RoutePlan {
  RouteAnswer answer;
  std::vector<Place> best;    ///< along answer.best
  std::vector<Place> second;  ///< along answer.second
};

/// What a person says of a link.
enum class LinkOrder {
  kBlock,    ///< is closed: its odds are the least there are, and drift back
  kUnblock,  ///< is open again, and not forbidden
  kForbid,   ///< no route goes there until it is unblocked
  kToll,     ///< routes count more time for it
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTES_H
