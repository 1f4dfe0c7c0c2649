// How long a route takes to plan, beside Dijkstra's plain search in the same map.

#include <boost/program_options.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "core/map/link_odds.h"
#include "core/route/route_planner.h"

namespace place_memory::measure {
namespace {

namespace po = boost::program_options;
using core::PlaceId;

constexpr double kSpacing = 1.5;       // of places [m]
constexpr double kShareOfLinks = 0.7;  // of neighbours between which there is no wall
constexpr double kShareOfDoors = 0.03;
constexpr double kHalfLife = 172800.0;  // [s]

/// Of this process, so that others on the machine do not count.
double processorTime() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;  // [ms]
}

/// Traversals of some days, and times that are not quite those of the length.
core::LinkDirection habit(double way, bool door, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  core::LinkDirection direction;
  direction.succeeded = 1 + static_cast<std::uint32_t>(5.0 * share(random));
  direction.through = direction.succeeded;
  direction.blocked = door ? 8.0 * share(random) : 0.0;
  direction.time = way / 0.3 * (0.8 + 0.5 * share(random));
  direction.last = std::chrono::nanoseconds(1);
  return direction;
}

/// As places lie in the corridors and halls of a building of one floor.
core::PlaceMap makeMap(std::size_t places, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(places)));
  std::vector<core::Place> made(places);
  for (std::size_t i = 0; i < places; ++i) {
    made[i].id = static_cast<PlaceId>(i + 1);
    made[i].label = "place " + std::to_string(i + 1);
    made[i].map_from_place = {kSpacing * (static_cast<double>(i % side) + 0.5 * share(random)),
                              kSpacing * (static_cast<double>(i / side) + 0.5 * share(random)),
                              0.0};
  }
  std::vector<core::PlaceLink> links;
  const auto join = [&](std::size_t one, std::size_t other) {
    if (other >= places || share(random) > kShareOfLinks) return;
    core::PlaceLink link;
    link.first = made[one].id;
    link.second = made[other].id;
    link.first_from_second = made[one].map_from_place.inverse() * made[other].map_from_place;
    const double way = std::hypot(link.first_from_second.x, link.first_from_second.y);
    const bool door = share(random) < kShareOfDoors;
    link.forward = habit(way, door, random);
    link.backward = habit(way, door, random);
    links.push_back(link);
  };
  for (std::size_t i = 0; i < places; ++i) {
    if ((i + 1) % side != 0) join(i, i + 1);
    join(i, i + side);
  }
  return {std::move(made), links, 0, std::chrono::nanoseconds(0)};
}

/// Dijkstra's search as it is written down, on lists of neighbours by index.
class PlainDijkstra {
 public:
  PlainDijkstra(const core::PlaceMap& map, const core::RoutePlanner& planner)
      : arcs_(map.size()), costs_(map.size()) {
    const core::LinkLearningOptions options;
    map.forEachLink([&](const core::PlaceLink& link) {
      for (const bool forward : {true, false}) {
        const core::LinkDirection& direction = forward ? link.forward : link.backward;
        const double time = core::expectedTime(link, direction, options);
        const double odds = planner.odds(link, direction, std::chrono::nanoseconds(1));
        const double cost = time + (1.0 / odds - 1.0) * core::expectedLoss(direction, time);
        const PlaceId from = forward ? link.first : link.second;
        const PlaceId to = forward ? link.second : link.first;
        arcs_[static_cast<std::size_t>(from - 1)].emplace_back(static_cast<std::size_t>(to - 1),
                                                               cost);
      }
    });
  }

  double leastCost(PlaceId from, PlaceId to) {
    using Item = std::pair<double, std::size_t>;
    std::fill(costs_.begin(), costs_.end(), std::numeric_limits<double>::infinity());
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    costs_[static_cast<std::size_t>(from - 1)] = 0.0;
    open.emplace(0.0, static_cast<std::size_t>(from - 1));
    while (!open.empty()) {
      const auto [cost, at] = open.top();
      open.pop();
      if (at == static_cast<std::size_t>(to - 1)) return cost;
      if (cost > costs_[at]) continue;
      for (const auto& [next, step] : arcs_[at]) {
        if (cost + step >= costs_[next]) continue;
        costs_[next] = cost + step;
        open.emplace(costs_[next], next);
      }
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<std::vector<std::pair<std::size_t, double>>> arcs_;
  std::vector<double> costs_;
};

class RouteBenchmark {
 public:
  RouteBenchmark(std::size_t places, std::size_t pairs)
      : map_(makeMap(places, 1)), planner_(map_, {}), pairs_(pairs) {}

  void run() {
    double begin = processorTime();
    plan(1, 2, false);
    const double prepared = (processorTime() - begin);
    PlainDijkstra plain(map_, planner_);
    double plain_ms = 0.0, ours_ms = 0.0, changed_ms = 0.0, second_ms = 0.0, expanded = 0.0;
    std::size_t done = 0, wrong = 0;
    while (done < pairs_) {
      const PlaceId from = anyPlace(), to = anyPlace();
      begin = processorTime();
      const double least = plain.leastCost(from, to);
      const double plain_took = (processorTime() - begin);
      if (!std::isfinite(least)) continue;  // walled in: another pair
      ++done;
      plain_ms += plain_took;
      begin = processorTime();
      const core::RouteAnswer answer = plan(from, to, false);
      ours_ms += (processorTime() - begin);
      expanded += static_cast<double>(planner_.expanded());
      if (std::abs(answer.best.cost - least) > 1e-3 * least + 0.01) ++wrong;
      if (done % 10 != 0) continue;
      begin = processorTime();
      plan(from, to, true);
      second_ms += (processorTime() - begin);
    }
    for (std::size_t i = 0; i < pairs_; ++i) {
      const PlaceId from = anyPlace(), to = anyPlace();
      if (plan(from, to, false).status != core::RouteAnswer::Status::kFound) continue;
      begin = processorTime();
      plan(from, to, false);
      const double before = (processorTime() - begin);
      begin = processorTime();
      learnOne();
      plan(from, to, false);
      changed_ms += (processorTime() - begin) - before;
    }
    const auto count = static_cast<double>(pairs_);
    std::cout << "| " << map_.size() << " | " << map_.links().size() << " | " << prepared << " | "
              << plain_ms / count << " | " << ours_ms / count << " | " << changed_ms / count
              << " | " << second_ms / (count / 10.0) << " | " << expanded / count << " | " << wrong
              << " |" << std::endl;
  }

 private:
  PlaceId anyPlace() {
    return std::uniform_int_distribution<PlaceId>(1, static_cast<PlaceId>(map_.size()))(random_);
  }

  core::RouteAnswer plan(PlaceId from, PlaceId to, bool second) {
    core::RouteRequest request;
    request.starts = {{from, 1.0}};
    request.goal = to;
    request.second = second;
    return planner_.plan(request, std::chrono::nanoseconds(1));
  }

  /// A traversal: every other one fails, the others are quicker than is expected by a tenth.
  void learnOne() {
    PlaceId from = core::kNoPlace;
    std::vector<PlaceId> neighbours;
    while (neighbours.empty()) {
      from = anyPlace();
      neighbours = map_.neighbours(from);
    }
    const core::PlaceLink& link = *map_.findLink(from, neighbours.front());
    core::LinkDirection direction = from == link.first ? link.forward : link.backward;
    const bool succeeded = ++learned_ % 2 == 0;
    const double expected = core::expectedTime(link, direction, {});
    const std::chrono::nanoseconds took(static_cast<std::int64_t>(0.9e9 * expected));
    direction = core::learned(direction, {from, neighbours.front(), {}, took, succeeded, ""},
                              expected, kHalfLife);
    const core::MapChange change{map_.version() + 1,
                                 std::chrono::nanoseconds(1),
                                 {core::LinkLearned{from, neighbours.front(), direction}}};
    map_.apply(change);
    planner_.follow(change);
  }

  core::PlaceMap map_;
  core::RoutePlanner planner_;
  std::size_t pairs_;
  std::size_t learned_ = 0;
  std::mt19937 random_{7};
};

int run(const po::variables_map& given) {
  std::cout << "| places | links | prepared, with the first plan [ms] | plain Dijkstra [ms] | "
               "planner [ms] | more after one link changed [ms] | with the second route [ms] | "
               "places gone on from | answers that differ |\n|---|---|---|---|---|---|---|---|---|"
            << std::endl;
  for (const std::size_t places : given["places"].as<std::vector<std::size_t>>()) {
    RouteBenchmark(places, given["pairs"].as<std::size_t>()).run();
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace place_memory::measure

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  try {
    po::options_description options("usage: place_memory_route_benchmark");
    options.add_options()("help", "show this")(
        "places",
        po::value<std::vector<std::size_t>>()->multitoken()->default_value(
            {1000, 10000, 100000, 1000000}, "1000 10000 100000 1000000"),
        "of each map")("pairs", po::value<std::size_t>()->default_value(1000),
                       "at random that are planned, at least 10");
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    if (given.count("help") > 0) {
      std::cout << options;
      return EXIT_SUCCESS;
    }
    return place_memory::measure::run(given);
  } catch (const std::exception& error) {
    std::cerr << "place_memory_route_benchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
