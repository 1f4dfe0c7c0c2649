#include <cmath>
#include <utility>

#include "core/map/link_odds.h"
#include "core/map/place_label.h"
#include "core/memory/place_memory_impl.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;
using std::chrono::nanoseconds;

// Clocks of two machines differ by no more.
constexpr nanoseconds kMostAhead = std::chrono::seconds(10);

constexpr char kScans[] = "scans";  // of which one was RECOGNIZED, or learned, after the other

[[noreturn]] void refuse(Reason reason, const std::string& why) {
  throw PlaceMemoryError(reason, why);
}

std::vector<Place> placesOf(const PlaceMap& map, const Route& route) {
  std::vector<Place> places;
  places.reserve(route.places.size());
  for (const PlaceId id : route.places) places.push_back(*map.find(id));
  return places;
}

const PlaceLink& requireLink(const PlaceMap& map, PlaceId from, PlaceId to) {
  const PlaceLink* link = map.findLink(from, to);
  if (link != nullptr) return *link;
  for (const PlaceId id : {from, to}) {
    if (map.find(id) == nullptr) {
      refuse(Reason::kUnknownPlace, "there is no place " + std::to_string(id));
    }
  }
  refuse(Reason::kUnknownLink, "no link joins " + called(map, from) + " and " + called(map, to) +
                                   ": only places are linked between which the robot drove");
}

LinkDirection& directionOf(PlaceLink& link, PlaceId from) {
  return from == link.first ? link.forward : link.backward;
}

void requireSound(const Traversal& traversal, nanoseconds now) {
  if (traversal.begin > traversal.end) {
    refuse(Reason::kInvalidTraversal, "the traversal ends before it begins");
  }
  // A link would not forget it before that time comes.
  if (traversal.end > now + kMostAhead) {
    refuse(Reason::kInvalidTraversal,
           "the traversal ends later than now: is the clock right where it is reported?");
  }
  if (!traversal.source.empty() && !isValidLabel(traversal.source)) {
    refuse(Reason::kInvalidTraversal, "the source has up to " + std::to_string(kMaxLabelBytes) +
                                          " bytes of UTF-8 text without control characters");
  }
}

}  // namespace

std::string called(const PlaceMap& map, PlaceId id) {
  const Place* place = map.find(id);
  return place == nullptr ? "place " + std::to_string(id) : "\"" + place->label + "\"";
}

Traversal PlaceMemory::Impl::wayTo(const Scan& scan, PlaceId from, PlaceId to) const {
  // Where the scan lasted the robot was there already.
  const bool knows_begin = scan.begin.count() > 0 && scan.begin <= scan.end;
  const nanoseconds arrived = knows_begin ? scan.begin : scan.end;
  const bool knows_left = stood_.place == from && stood_.until <= arrived;
  return {from, to, knows_left ? stood_.until : arrived, arrived, true, kScans};
}

std::optional<LinkLearned> PlaceMemory::Impl::learnedBy(const Traversal& traversal) const {
  const PlaceLink* link = state_.map.findLink(traversal.from, traversal.to);
  if (link == nullptr) return std::nullopt;
  const LinkDirection& before = traversal.from == link->first ? link->forward : link->backward;
  return LinkLearned{
      traversal.from, traversal.to,
      learned(before, traversal, expectedTime(*link, before, links_), links_.half_life), traversal};
}

void PlaceMemory::Impl::reportTraversal(const Traversal& traversal) {
  requireSound(traversal, writer_.now());
  queue_.run([&] {
    requireLink(state_.map, traversal.from, traversal.to);
    writer_.commit({*learnedBy(traversal)});
    if (traversal.succeeded) reported_to_ = traversal.to;
  });
}

void PlaceMemory::Impl::setLink(PlaceId from, PlaceId to, LinkOrder order, double toll,
                                bool both_ways) {
  // Written so that NaN fails.
  if (order == LinkOrder::kToll && !(toll >= 0.0 && std::isfinite(toll))) {
    refuse(Reason::kInvalidTraversal, "the cost of a link is a time of 0 s or more");
  }
  queue_.run([&] {
    PlaceLink link = requireLink(state_.map, from, to);
    const bool driven = wasDriven(link);
    std::vector<MapEdit> edits;
    for (const auto& [begin, end] : {std::pair{from, to}, std::pair{to, from}}) {
      if (begin != from && !both_ways) continue;
      LinkDirection& direction = directionOf(link, begin);
      switch (order) {
        case LinkOrder::kBlock:
          direction = blockedNow(direction, driven, writer_.now(), links_.half_life);
          break;
        case LinkOrder::kUnblock:
          direction = unblocked(direction);
          break;
        case LinkOrder::kForbid:
          direction.forbidden = true;
          break;
        case LinkOrder::kToll:
          direction.toll = toll;
          break;
      }
      edits.emplace_back(LinkLearned{begin, end, direction});
    }
    writer_.commit(std::move(edits));
  });
}

std::pair<double, double> PlaceMemory::Impl::linkOdds(PlaceId first, PlaceId second) {
  const nanoseconds now = writer_.now();
  const std::lock_guard<std::mutex> lock(state_.routes_mutex);
  PlaceLink link = requireLink(state_.map, first, second);
  return {state_.routes.odds(link, directionOf(link, first), now),
          state_.routes.odds(link, directionOf(link, second), now)};
}

std::vector<Traversal> PlaceMemory::Impl::traversals() {
  return queue_.run(
      [&] { return writer_.query([](PlaceStore& store) { return store.traversals(); }); });
}

std::vector<RouteStart> PlaceMemory::Impl::startsOf(const RouteQuery& query) const {
  if (query.start) {
    const Place* place = placeAt(*query.start, kNoSession);
    if (place == nullptr) return {};
    return {{place->id, 1.0}};
  }
  if (!query.starts.empty()) return query.starts;
  const Whereabouts now = read([](const MemoryState& state) { return state.whereabouts.now(); });
  const PlaceId place = now.current != kNoPlace ? now.current : now.previous;
  if (place == kNoPlace) return {};
  return {{place, 1.0}};
}

const Place* PlaceMemory::Impl::placeAt(const RouteEnd& end, SessionId session) const {
  const PlaceMap& map = state_.map;
  if (end.id != kNoPlace) return map.find(end.id);
  if (!end.label.empty() || !end.pose) return map.find(end.label);
  const Place* nearest = nullptr;
  double least = 0.0;
  for (const Place& place : map.places()) {
    if (session != kNoSession && place.session != session) continue;
    const double distance =
        std::hypot(place.map_from_place.x - end.pose->x, place.map_from_place.y - end.pose->y);
    if (nearest != nullptr && distance >= least) continue;
    nearest = &place;
    least = distance;
  }
  return nearest;
}

RoutePlan PlaceMemory::Impl::plan(const RouteQuery& query) {
  const nanoseconds now = writer_.now();
  RouteRequest request;
  RoutePlan plan;
  const std::lock_guard<std::mutex> lock(state_.routes_mutex);
  request.starts = startsOf(query);
  if (request.starts.empty() && !query.start) {
    plan.answer.status = RouteAnswer::Status::kNotLocalized;
    plan.answer.reason =
        "where the robot is, is not known: scan and recognize a place, or name a start";
    return plan;
  }
  const Place* start =
      request.starts.empty() ? nullptr : state_.map.find(request.starts.front().place);
  if (start == nullptr) {
    plan.answer.status = RouteAnswer::Status::kUnknownStart;
    plan.answer.reason = "there is no such place to start from";
    return plan;
  }
  const Place* goal = placeAt(query.goal, start->session);
  if (goal == nullptr) {
    const std::string& label = query.goal.label;
    plan.answer.status = RouteAnswer::Status::kUnknownGoal;
    plan.answer.reason = label.empty() || !isValidLabel(label)
                             ? "there is no such place to go to"
                             : "there is no place \"" + label + "\" to go to";
    return plan;
  }
  request.goal = goal->id;
  request.avoided = query.avoided;
  request.second = query.second;
  plan.answer = state_.routes.plan(request, now);
  plan.best = placesOf(state_.map, plan.answer.best);
  if (plan.answer.second) plan.second = placesOf(state_.map, *plan.answer.second);
  return plan;
}

}  // namespace place_memory::core
