#include "routes/route_minds.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/map/link_odds.h"

namespace place_memory::routes {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

core::PlaceId idOf(std::size_t place) { return static_cast<core::PlaceId>(place + 1); }

std::chrono::nanoseconds toStamp(double time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(time));
}

}  // namespace

LearningMind::LearningMind(const DoorWorld& world, const core::LinkLearningOptions& options)
    : options_(options), map_(world.learnedMap()), planner_(map_, options) {}

std::optional<Way> LearningMind::plan(std::size_t from, std::size_t to, const Steps& avoided,
                                      double time) {
  core::RouteRequest request;
  request.starts = {{idOf(from), 1.0}};
  request.goal = idOf(to);
  request.second = false;
  for (const auto& [begin, end] : avoided) request.avoided.emplace_back(idOf(begin), idOf(end));
  const core::RouteAnswer answer = planner_.plan(request, toStamp(time));
  if (answer.status != core::RouteAnswer::Status::kFound) return std::nullopt;
  Way way;
  for (const core::PlaceId id : answer.best.places) way.push_back(static_cast<std::size_t>(id - 1));
  return way;
}

void LearningMind::notice(std::size_t from, std::size_t to, double begin, double end,
                          bool succeeded) {
  const core::Traversal traversal{idOf(from),   idOf(to),  toStamp(begin),
                                  toStamp(end), succeeded, "simulation"};
  const core::PlaceLink& link = *map_.findLink(traversal.from, traversal.to);
  const core::LinkDirection& before = traversal.from == link.first ? link.forward : link.backward;
  const core::LinkDirection now = core::learned(
      before, traversal, core::expectedTime(link, before, options_), options_.half_life);
  const core::MapChange change{map_.version() + 1,
                               traversal.end,
                               {core::LinkLearned{traversal.from, traversal.to, now, traversal}}};
  map_.apply(change);
  planner_.follow(change);
  ++traversals_;
}

double LearningMind::traversalsALink() const {
  return static_cast<double>(traversals_) / static_cast<double>(map_.links().size());
}

double OracleMind::cost(std::size_t passage, double time) const {
  const double through = world_.passages()[passage].time;
  if (knows_ == Knows::kTimesAlone) return through;
  if (knows_ == Knows::kEveryDoor) return world_.isOpen(passage, time) ? through : kNever;
  const double odds = std::max(world_.share(passage), core::kLeastOdds);
  return through + (1.0 / odds - 1.0) * world_.timeLost(passage, time);
}

// Over all passages again and again: a floor has few.
std::optional<Way> OracleMind::plan(std::size_t from, std::size_t to, const Steps& avoided,
                                    double time) {
  const std::size_t none = world_.places();
  std::vector<double> costs(world_.places(), kNever);
  std::vector<std::size_t> before(world_.places(), none);
  costs[from] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < world_.passages().size(); ++i) {
      const Passage& passage = world_.passages()[i];
      for (const auto& step :
           {std::pair(passage.one, passage.other), std::pair(passage.other, passage.one)}) {
        if (std::find(avoided.begin(), avoided.end(), step) != avoided.end()) continue;
        const double further = costs[step.first] + cost(i, time);
        if (further >= costs[step.second]) continue;
        costs[step.second] = further;
        before[step.second] = step.first;
        changed = true;
      }
    }
  }
  if (costs[to] == kNever) return std::nullopt;
  Way way{to};
  while (way.back() != from) way.push_back(before[way.back()]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace place_memory::routes
