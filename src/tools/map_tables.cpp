#include "tools/map_tables.h"

#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <set>
#include <string>

namespace place_memory::tools {
namespace {

std::int64_t integer(std::size_t number) { return static_cast<std::int64_t>(number); }

/// In UTC; empty where there is none.
std::string timeInWords(std::chrono::nanoseconds time) {
  if (time.count() == 0) return "";
  const auto seconds =
      static_cast<std::time_t>(std::chrono::duration_cast<std::chrono::seconds>(time).count());
  std::tm date{};
  gmtime_r(&seconds, &date);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &date);
  return text.data();
}

double lengthOf(const core::PlaceLink& link) {
  return std::hypot(link.first_from_second.x, link.first_from_second.y);
}

}  // namespace

RecordTable placeTable(const std::vector<core::Place>& places) {
  RecordTable table({"id", "label", "session", "x", "y", "yaw", "learned"});
  for (const core::Place& place : places) {
    const core::Pose2d& pose = place.map_from_place;
    table.add({place.id, place.label, place.session, Decimal{pose.x}, Decimal{pose.y},
               Decimal{pose.yaw}, timeInWords(place.learned)});
  }
  return table;
}

RecordTable linkTable(const core::MapSnapshot& map, const core::Place& place) {
  std::map<core::PlaceId, std::string> labels;
  for (const core::Place& other : map.places) labels[other.id] = other.label;
  RecordTable table({"linked to", "metres", "arrived", "gave up"});
  for (const core::PlaceLink& link : map.links) {
    if (link.first != place.id && link.second != place.id) continue;
    const bool is_first = link.first == place.id;
    const core::LinkDirection& there = is_first ? link.forward : link.backward;
    table.add({labels[is_first ? link.second : link.first], Decimal{lengthOf(link), 2},
               std::int64_t{there.succeeded}, std::int64_t{there.failed}});
  }
  return table;
}

RecordTable historyTable(const std::vector<core::PastChange>& changes) {
  RecordTable table({"back", "made", "change"});
  std::int64_t back = 0;
  for (const core::PastChange& change : changes) {
    table.add({++back, timeInWords(change.stamp),
               change.words + (change.can_be_undone ? "" : " (cannot be undone)")});
  }
  return table;
}

RecordTable statsTable(const core::MapSnapshot& map, std::uintmax_t bytes) {
  std::set<core::SessionId> sessions;
  for (const core::Place& place : map.places) sessions.insert(place.session);
  double way = 0.0;
  std::int64_t arrived = 0;
  std::int64_t gave_up = 0;
  for (const core::PlaceLink& link : map.links) {
    way += lengthOf(link);
    arrived += link.forward.succeeded + link.backward.succeeded;
    gave_up += link.forward.failed + link.backward.failed;
  }
  RecordTable table({"places", "links", "sessions", "metres of links", "arrived", "gave up",
                     "version", "changed", "bytes"});
  table.add({integer(map.places.size()), integer(map.links.size()), integer(sessions.size()),
             Decimal{way, 1}, arrived, gave_up, static_cast<std::int64_t>(map.version),
             timeInWords(map.stamp), static_cast<std::int64_t>(bytes)});
  return table;
}

}  // namespace place_memory::tools
