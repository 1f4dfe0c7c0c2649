#include "node/map/map_messages.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "node/base/conversions.h"

namespace place_memory::node {
namespace {

using PlacePair = std::pair<core::PlaceId, core::PlaceId>;

Traversals toMessage(const core::LinkDirection& direction) {
  Traversals message;
  message.succeeded = direction.succeeded;
  message.failed = direction.failed;
  message.last = toRosTime(direction.last);
  message.through = direction.through;
  message.blocked = direction.blocked;
  message.time = direction.time;
  message.time_sigma = direction.time_sigma;
  message.lost_time = direction.lost_time;
  message.toll = direction.toll;
  message.forbidden = static_cast<std::uint8_t>(direction.forbidden);
  return message;
}

PlacePair ascending(core::PlaceId one, core::PlaceId other) { return std::minmax(one, other); }

template <class Key, class Value, class Condition>
void eraseIf(std::map<Key, Value>& map, const Condition& condition) {
  for (auto at = map.begin(); at != map.end();) at = condition(*at) ? map.erase(at) : ++at;
}

// Follows the edits one by one.
class Summary {
 public:
  void operator()(const core::PlaceAdded& edit) { added_[edit.place.id] = edit.place; }

  void operator()(const core::PlaceMoved& edit) {
    const auto added = added_.find(edit.id);
    if (added == added_.end()) {
      moved_[edit.id] = edit;
    } else {
      added->second.map_from_place = edit.map_from_place;
      added->second.session = edit.session;
    }
  }

  void operator()(const core::PlaceRenamed& edit) {
    const auto added = added_.find(edit.id);
    if (added == added_.end()) {
      renamed_[edit.id] = edit.label;
    } else {
      added->second.label = edit.label;
    }
  }

  void operator()(const core::GridAdapted& edit) { adapted_.insert(edit.id); }

  void operator()(const core::PlaceRemoved& edit) {
    const core::PlaceId id = edit.id;
    moved_.erase(id);
    renamed_.erase(id);
    adapted_.erase(id);
    const auto is_of_it = [id](const auto& item) {
      return item.first.first == id || item.first.second == id;
    };
    eraseIf(linked_, is_of_it);
    eraseIf(travelled_, is_of_it);
    if (added_.erase(id) == 0) removed_.insert(id);
  }

  void operator()(const core::LinkAdded& edit) {
    const PlacePair pair = ascending(edit.link.first, edit.link.second);
    forgetTraversals(pair);
    linked_[pair] = edit.link;
  }

  void operator()(const core::LinkRemoved& edit) {
    const PlacePair pair = ascending(edit.first, edit.second);
    forgetTraversals(pair);
    linked_.erase(pair);
    unlinked_.insert(pair);
  }

  void operator()(const core::LinkLearned& edit) {
    const PlacePair pair = ascending(edit.from, edit.to);
    const auto linked = linked_.find(pair);
    if (linked == linked_.end()) {
      travelled_[{edit.from, edit.to}] = edit.direction;
    } else {
      (edit.from < edit.to ? linked->second.forward : linked->second.backward) = edit.direction;
    }
  }

  void operator()(const core::MapCleared& /*edit*/) {
    *this = Summary();
    cleared_ = true;
  }

  void writeTo(MapChange& message) const {
    message.cleared = static_cast<std::uint8_t>(cleared_);
    message.removed.assign(removed_.begin(), removed_.end());
    for (const auto& [first, second] : unlinked_) {
      message.unlinked_first.push_back(first);
      message.unlinked_second.push_back(second);
    }
    for (const auto& [id, place] : added_) message.added.push_back(node::toMessage(place));
    for (const auto& [id, move] : moved_) {
      message.moved.push_back(id);
      message.moved_locations.push_back(toPose2D(move.map_from_place));
      message.moved_sessions.push_back(move.session);
    }
    for (const auto& [id, label] : renamed_) {
      message.renamed.push_back(id);
      message.new_labels.push_back(label);
    }
    message.adapted.assign(adapted_.begin(), adapted_.end());
    for (const auto& [pair, link] : linked_) message.linked.push_back(node::toMessage(link));
    for (const auto& [way, direction] : travelled_) {
      message.travelled_from.push_back(way.first);
      message.travelled_to.push_back(way.second);
      message.travelled.push_back(toMessage(direction));
    }
  }

 private:
  void forgetTraversals(const PlacePair& pair) {
    travelled_.erase(pair);
    travelled_.erase({pair.second, pair.first});
  }

  bool cleared_ = false;
  std::set<core::PlaceId> removed_;
  std::set<PlacePair> unlinked_;
  std::map<core::PlaceId, core::Place> added_;
  std::map<core::PlaceId, core::PlaceMoved> moved_;
  std::map<core::PlaceId, std::string> renamed_;
  std::set<core::PlaceId> adapted_;
  std::map<PlacePair, core::PlaceLink> linked_;
  std::map<PlacePair, core::LinkDirection> travelled_;  // from, to
};

}  // namespace

Place toMessage(const core::Place& place) {
  Place message;
  message.id = place.id;
  message.label = place.label;
  message.location = toPose2D(place.map_from_place);
  message.learned = toRosTime(place.learned);
  message.session = place.session;
  message.robot = toPose2D(place.place_from_robot);
  std::copy(place.identity.begin(), place.identity.end(), message.identity.begin());
  return message;
}

PlaceLink toMessage(const core::PlaceLink& link) {
  PlaceLink message;
  message.first_id = link.first;
  message.second_id = link.second;
  message.transform = toPose2D(link.first_from_second);
  std::copy(link.covariance.begin(), link.covariance.end(), message.covariance.begin());
  message.forward = toMessage(link.forward);
  message.backward = toMessage(link.backward);
  return message;
}

PlaceGraph toMessage(const core::MapSnapshot& map, const std::string& map_frame) {
  PlaceGraph message;
  message.header = makeHeader(map_frame, toRosTime(map.stamp));
  message.version = map.version;
  message.places.reserve(map.places.size());
  for (const core::Place& place : map.places) message.places.push_back(toMessage(place));
  message.links.reserve(map.links.size());
  for (const core::PlaceLink& link : map.links) message.links.push_back(toMessage(link));
  return message;
}

MapChange toMessage(const core::MapChange& change, const std::string& map_frame) {
  Summary summary;
  for (const core::MapEdit& edit : change.edits) std::visit(summary, edit);
  MapChange message;
  message.header = makeHeader(map_frame, toRosTime(change.stamp));
  message.version = change.version;
  summary.writeTo(message);
  return message;
}

}  // namespace place_memory::node
