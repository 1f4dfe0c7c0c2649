#include "core/memory/driven_places.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "core/map/place_identity.h"
#include "core/memory/place_travels.h"
#include "core/memory/travelled_links.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

// A place that lies off by less is where it was [m], [rad].
constexpr double kSamePlace = 1e-9;

bool same(const Pose2d& one, const Pose2d& other) {
  return std::abs(one.x - other.x) < kSamePlace && std::abs(one.y - other.y) < kSamePlace &&
         std::abs(wrapAngle(one.yaw - other.yaw)) < kSamePlace;
}

std::string madeLabel(PlaceId id) { return "place_" + std::to_string(id); }

std::string freeLabel(PlaceId id, const PlaceMap& map) {
  std::string free = madeLabel(id);
  for (int number = 2; map.find(free) != nullptr; ++number) {
    free = madeLabel(id) + "_" + std::to_string(number);
  }
  return free;
}

using NodesOfPlaces = std::map<PlaceId, const ScanNode*>;

NodesOfPlaces placesOf(const KeptMap& map) {
  NodesOfPlaces places;
  for (const ScanNode& node : map.nodes) {
    if (node.place != kNoPlace) places[node.place] = &node;
  }
  return places;
}

Pose2d placeFromRobot(const ScanNode& node, const PlaceMap& map) {
  const Place* place = map.find(node.place);
  // The axes of a new place are the map's.
  return place == nullptr ? Pose2d{0.0, 0.0, node.pose.yaw} : place->place_from_robot;
}

// To a mapper session 1 is the map: where no place is of it, the oldest one is.
void makeOldestTheFirst(std::vector<ScanNode>& nodes) {
  constexpr int kFirst = static_cast<int>(kFirstSession);
  int oldest = 0;
  for (const ScanNode& node : nodes) {
    if (node.place == kNoPlace) continue;
    if (oldest == 0 || node.session < oldest) oldest = node.session;
  }
  if (oldest == 0 || oldest == kFirst) return;
  for (ScanNode& node : nodes) {
    if (node.session == kFirst) {
      node.session = oldest;
    } else if (node.session == oldest) {
      node.session = kFirst;
    }
  }
}

}  // namespace

KeptMap DrivenPlaces::take(const PlaceMap& map, const PlaceStore& store) {
  KeptMap taken = store.scans();
  // Where somebody else moved a place, its scan is moved along.
  for (ScanNode& node : taken.nodes) {
    if (node.place == kNoPlace) continue;
    const Place& place = *map.find(node.place);
    const Pose2d pose = place.map_from_place * place.place_from_robot;
    if (!same(pose, node.pose)) node.pose = pose;
    node.session = static_cast<int>(place.session);
  }
  std::vector<ScanNode> others;
  const NodesOfPlaces known = placesOf(taken);
  for (const Place& place : map.places()) {
    if (place.label != madeLabel(place.id)) taken.named.push_back(place.id);
    if (known.count(place.id) > 0) continue;
    ScanNode node = nodeOf(place, store);
    if (!node.readings->empty()) others.push_back(std::move(node));
  }
  std::move(others.begin(), others.end(), std::back_inserter(taken.nodes));
  makeOldestTheFirst(taken.nodes);
  kept(map, taken);
  return taken;
}

ScanNode DrivenPlaces::nodeOf(const Place& place, const PlaceStore& store) const {
  ScanNode node;
  node.stamp = place.learned;
  node.session = static_cast<int>(place.session);
  node.pose = place.map_from_place * place.place_from_robot;
  node.place = place.id;
  std::vector<SonarReading> readings;
  try {
    readings = store.readings(place.id);
  } catch (const StoreError&) {  // the store's setAside() tells of it
  }
  node.readings = std::make_shared<const std::vector<SonarReading>>(
      movedReadings(readings, place.place_from_robot.inverse()));
  return node;
}

PlaceAdded DrivenPlaces::added(const ScanNode& node, const PlaceMap& map) const {
  PlaceAdded edit;
  edit.place.id = node.place;
  edit.place.identity = makePlaceIdentity();
  edit.place.label = freeLabel(node.place, map);
  edit.place.place_from_robot = placeFromRobot(node, map);
  edit.place.map_from_place = node.pose * edit.place.place_from_robot.inverse();
  edit.place.learned = node.stamp;
  edit.place.session = node.session;
  std::vector<SonarReading> readings = movedReadings(*node.readings, edit.place.place_from_robot);
  edit.grid = std::make_shared<const EvidenceGrid>(sonar_.build(readings, geometry_));
  edit.readings = std::make_shared<const std::vector<SonarReading>>(std::move(readings));
  return edit;
}

std::vector<MapEdit> DrivenPlaces::edits(const PlaceMap& map, const KeptMap& drive, PlaceId next_id,
                                         bool only_new) const {
  std::vector<MapEdit> edits;
  const NodesOfPlaces places = placesOf(drive);
  std::set<PlaceId> there;  // places once the edits are made
  for (const PlaceId id : kept_) {
    if (!only_new && places.count(id) == 0 && map.find(id) != nullptr) {
      edits.emplace_back(PlaceRemoved{id});
    }
  }
  for (const auto& [id, node] : places) {
    const Place* place = map.find(id);
    if (place == nullptr) {
      if (id < next_id) continue;
      edits.emplace_back(added(*node, map));
    } else if (!only_new) {
      const Pose2d pose = node->pose * place->place_from_robot.inverse();
      if (!same(pose, place->map_from_place) || place->session != node->session) {
        edits.emplace_back(PlaceMoved{id, pose, node->session});
      }
    }
    there.insert(id);
  }
  const auto is_new = [&map](PlaceId id) { return map.find(id) == nullptr; };
  TravelledLinks links(map, learning_);
  for (const PlaceTravel& travel : travelsOf(drive)) {
    if (there.count(travel.from) == 0 || there.count(travel.to) == 0) continue;
    if (only_new && !is_new(travel.from) && !is_new(travel.to)) continue;
    links.add(travel, placeFromRobot(*places.at(travel.from), map),
              placeFromRobot(*places.at(travel.to), map));
  }
  edits.insert(edits.end(), links.edits().begin(), links.edits().end());
  return edits;
}

std::vector<MapEdit> DrivenPlaces::travels(const PlaceMap& map, const KeptMap& drive) const {
  const NodesOfPlaces places = placesOf(drive);
  TravelledLinks links(map, learning_);
  for (const PlaceTravel& travel : travelsOf(drive)) {
    if (map.findLink(travel.from, travel.to) == nullptr) continue;
    links.add(travel, placeFromRobot(*places.at(travel.from), map),
              placeFromRobot(*places.at(travel.to), map));
  }
  return links.edits();
}

void DrivenPlaces::kept(const PlaceMap& map, const KeptMap& drive) {
  for (const auto& [id, node] : placesOf(drive)) {
    if (map.find(id) != nullptr) kept_.insert(id);
  }
  for (auto id = kept_.begin(); id != kept_.end();) {
    id = map.find(*id) == nullptr ? kept_.erase(id) : std::next(id);
  }
}

}  // namespace place_memory::core
