#include "core/memory/driven_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "core/map/place_identity.h"
#include "core/memory/link_pose.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

// A place that lies off by less is where it was [m], [rad].
constexpr double kSamePlace = 1e-9;

bool same(const Pose2d& one, const Pose2d& other) {
  return std::abs(one.x - other.x) < kSamePlace && std::abs(one.y - other.y) < kSamePlace &&
         std::abs(wrapAngle(one.yaw - other.yaw)) < kSamePlace;
}

using NodesOfPlaces = std::map<PlaceId, const ScanNode*>;

NodesOfPlaces placesOf(const KeptMap& map) {
  NodesOfPlaces places;
  for (const ScanNode& node : map.nodes) {
    if (node.place != kNoPlace) places[node.place] = &node;
  }
  return places;
}

}  // namespace

DrivenMap::DrivenMap(const std::string& path, double cell_size, const SonarModelOptions& sonar,
                     const StoreOpening& opening)
    : geometry_{cell_size},
      sonar_(sonar),
      store_(path, cell_size, opening),
      map_(store_.map()),
      kept_(store_.scans()) {
  // Where somebody else moved a place, its scan is moved along.
  for (ScanNode& node : kept_.nodes) {
    if (node.place == kNoPlace) continue;
    const Place& place = *map_.find(node.place);
    const Pose2d pose = place.map_from_place * place.place_from_robot;
    if (!same(pose, node.pose)) node.pose = pose;
    node.session = static_cast<int>(place.session);
  }
  std::vector<ScanNode> others;
  const NodesOfPlaces known = placesOf(kept_);
  for (const Place& place : map_.places()) {
    if (known.count(place.id) > 0) continue;
    ScanNode node = nodeOf(place);
    if (!node.readings->empty()) others.push_back(std::move(node));
  }
  std::move(others.begin(), others.end(), std::back_inserter(kept_.nodes));
}

ScanNode DrivenMap::nodeOf(const Place& place) const {
  ScanNode node;
  node.stamp = place.learned;
  node.session = static_cast<int>(place.session);
  node.pose = place.map_from_place * place.place_from_robot;
  node.place = place.id;
  std::vector<SonarReading> readings;
  try {
    readings = store_.readings(place.id);
  } catch (const StoreError&) {  // setAside() tells of it
  }
  node.readings = std::make_shared<const std::vector<SonarReading>>(
      movedReadings(readings, place.place_from_robot.inverse()));
  return node;
}

PlaceAdded DrivenMap::added(const ScanNode& node) const {
  PlaceAdded edit;
  edit.place.id = node.place;
  edit.place.identity = makePlaceIdentity();
  edit.place.label = freeLabel(node.place);
  edit.place.place_from_robot = placeFromRobot(node);
  edit.place.map_from_place = node.pose * edit.place.place_from_robot.inverse();
  edit.place.learned = node.stamp;
  edit.place.session = node.session;
  std::vector<SonarReading> readings = movedReadings(*node.readings, edit.place.place_from_robot);
  edit.grid = std::make_shared<const EvidenceGrid>(sonar_.build(readings, geometry_));
  edit.readings = std::make_shared<const std::vector<SonarReading>>(std::move(readings));
  return edit;
}

Pose2d DrivenMap::placeFromRobot(const ScanNode& node) const {
  const Place* place = map_.find(node.place);
  // The axes of a new place are the map's.
  return place == nullptr ? Pose2d{0.0, 0.0, node.pose.yaw} : place->place_from_robot;
}

std::optional<PlaceLink> DrivenMap::linkOf(const ScanNode& node, const KeptMap& map) const {
  Pose2d from_node = node.motion;  // of the robot, from where it stood before
  std::optional<NodeIndex> before = node.before;
  while (before && map.nodes[*before].place == kNoPlace) {
    from_node = map.nodes[*before].motion * from_node;
    before = map.nodes[*before].before;
  }
  if (!before) return std::nullopt;
  const ScanNode& previous = map.nodes[*before];
  const Stand there{previous.place, placeFromRobot(previous).inverse(), {}};
  const Stand here{node.place, from_node * placeFromRobot(node).inverse(), {}};
  if (there.place < here.place) {
    return linkTo(here.place, here.odom_from_place, there, true, node.stamp);
  }
  PlaceLink link = linkTo(there.place, there.odom_from_place, here, true, node.stamp);
  std::swap(link.forward, link.backward);
  return link;
}

std::string DrivenMap::freeLabel(PlaceId id) const {
  const std::string label = "place_" + std::to_string(id);
  std::string free = label;
  for (int number = 2; map_.find(free) != nullptr; ++number) {
    free = label + "_" + std::to_string(number);
  }
  return free;
}

void DrivenMap::keep(const KeptMap& map) {
  MapChange change;
  change.version = map_.version() + 1;
  change.stamp = map_.stamp();
  const NodesOfPlaces places = placesOf(map);
  for (const auto& [id, node] : placesOf(kept_)) {
    if (places.count(id) == 0) change.edits.emplace_back(PlaceRemoved{id});
  }
  for (const auto& [id, node] : places) {
    change.stamp = std::max(change.stamp, node->stamp);
    const Place* place = map_.find(id);
    if (place == nullptr) {
      change.edits.emplace_back(added(*node));
      continue;
    }
    const Pose2d pose = node->pose * place->place_from_robot.inverse();
    if (!same(pose, place->map_from_place) || place->session != node->session) {
      change.edits.emplace_back(PlaceMoved{id, pose, node->session});
    }
  }
  for (const auto& [id, node] : places) {
    if (map_.find(id) != nullptr) continue;
    if (const auto link = linkOf(*node, map)) change.edits.emplace_back(LinkAdded{*link});
  }
  map_.check(change);
  store_.commit(change, map);
  map_.apply(change);
  kept_ = map;
}

std::string DrivenMap::labelOf(PlaceId id) const {
  const Place* place = map_.find(id);
  return place == nullptr ? std::string() : place->label;
}

}  // namespace place_memory::core
