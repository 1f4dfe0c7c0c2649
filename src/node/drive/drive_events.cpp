#include "node/drive/drive_events.h"

#include <place_memory/MapEvent.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace place_memory::node {
namespace {

std::string fixed(double number, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

std::string why(const std::vector<DriveEvent>& events) {
  const auto has = [&](std::uint8_t kind) {
    return std::any_of(events.begin(), events.end(),
                       [kind](const DriveEvent& event) { return event.kind == kind; });
  };
  if (has(MapEvent::CLOSED)) return "a loop was closed";
  if (has(MapEvent::JOINED)) return "what was driven apart was joined to the map";
  if (has(MapEvent::TAKEN_BACK)) return "a closure was taken back";
  return "a scan was matched to places about, or the whole map was corrected";
}

}  // namespace

std::string DriveEvents::labels(const std::vector<core::PlaceId>& places) const {
  std::string text;
  for (const core::PlaceId id : places) text += (text.empty() ? "" : ", ") + label_(id);
  return text.empty() ? "none" : text;
}

DriveEvent DriveEvents::eventOf(const core::ScanDecision& decision) const {
  return {
      MapEvent::NEW_PLACE, decision.stamp, {decision.place}, "new place " + label_(decision.place)};
}

DriveEvent DriveEvents::eventOf(const core::MapperEvent& event) const {
  using Kind = core::MapperEvent::Kind;
  DriveEvent told{MapEvent::DOUBT, event.stamp, event.witnesses, ""};
  const std::string witnesses = "; witnesses: " + labels(event.witnesses);
  switch (event.kind) {
    case Kind::kClosed:
      told.kind = MapEvent::CLOSED;
      told.sentence = "a loop was closed" + witnesses;
      break;
    case Kind::kJoined:
      told.kind = MapEvent::JOINED;
      told.sentence = "what was driven apart was joined to the map" + witnesses;
      break;
    case Kind::kRefused:
      told.sentence = "a closure was not made, because the map speaks against it" + witnesses;
      break;
    case Kind::kTakenBack:
      told.kind = MapEvent::TAKEN_BACK;
      told.sentence =
          "a closure was taken back: the robot did not find there what it should see, or a person "
          "cut it";
      break;
    case Kind::kLost:
      told.kind = MapEvent::LOST;
      told.sentence =
          "the robot is not where it was thought to be: it was carried, say; where it is on the "
          "map is sought";
      break;
  }
  return told;
}

std::vector<DriveEvent> DriveEvents::update(const OdometryMoment& now,
                                            const std::vector<core::ScanDecision>& decisions,
                                            const std::vector<core::MapperEvent>& of_map,
                                            const std::optional<core::Pose2d>& map_from_odom) {
  std::vector<DriveEvent> events;
  for (const core::MapperEvent& event : of_map) events.push_back(eventOf(event));
  for (const core::ScanDecision& decision : decisions) {
    if (decision.kind == core::ScanDecision::Kind::kNewPlace) events.push_back(eventOf(decision));
  }
  if (map_from_odom && !map_from_odom_) {
    events.push_back({MapEvent::FOUND, now.stamp, {}, "it is known where on the map the robot is"});
  } else if (map_from_odom) {
    const core::Pose2d after = *map_from_odom * now.odom_from_base;
    const core::Pose2d before = *map_from_odom_ * now.odom_from_base;
    const double jump = std::hypot(after.x - before.x, after.y - before.y);
    if (jump > largest_jump_) {
      events.push_back(
          {MapEvent::JUMP,
           now.stamp,
           {},
           "the robot was moved by " + fixed(jump, 2) + " m on the map: " + why(events)});
    }
  }
  map_from_odom_ = map_from_odom;
  return events;
}

}  // namespace place_memory::node
