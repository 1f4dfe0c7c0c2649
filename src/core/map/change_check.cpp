#include "core/map/change_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/map/place_label.h"

namespace place_memory::core {
namespace {

using Ends = std::pair<PlaceId, PlaceId>;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

std::string inWords(PlaceId id) { return "place " + std::to_string(id); }

std::string inWords(const Ends& ends) {
  return "link between the places " + std::to_string(ends.first) + " and " +
         std::to_string(ends.second);
}

/// The map as it will be after the edits so far, kept as what differs from the map as it is.
class ChangeCheck {
 public:
  /// A store is opened by one change of so many edits as it has rows.
  ChangeCheck(const PlaceMap& map, std::size_t edits) : map_(map) {
    labels_.reserve(edits);
    ids_.reserve(edits);
  }

  void operator()(const PlaceAdded& edit) {
    const Place& place = edit.place;
    if (place.id <= kNoPlace) refuse("the id of a place is above 0");
    if (label(place.id) != nullptr) refuse(inWords(place.id) + " is in the map already");
    checkLabel(place.id, place.label);
    checkPose(place.id, place.map_from_place);
    checkPose(place.id, place.place_from_robot);
    checkSession(place.session);
    labels_[place.id] = place.label;
    ids_[place.label] = place.id;
  }

  void operator()(const PlaceMoved& edit) {
    require(edit.id);
    checkPose(edit.id, edit.map_from_place);
    checkSession(edit.session);
  }

  void operator()(const PlaceRenamed& edit) {
    const std::string before = require(edit.id);
    if (before == edit.label) return;
    checkLabel(edit.id, edit.label);
    ids_[before] = kNoPlace;
    ids_[edit.label] = edit.id;
    labels_[edit.id] = edit.label;
  }

  void operator()(const GridAdapted& edit) { require(edit.id); }

  void operator()(const PlaceRemoved& edit) {
    ids_[require(edit.id)] = kNoPlace;
    labels_[edit.id].clear();
    for (auto& [ends, is_there] : links_) {
      if (ends.first == edit.id || ends.second == edit.id) is_there = false;
    }
    if (is_cleared_) return;
    for (const PlaceId other : map_.neighbours(edit.id)) {
      links_[std::minmax(edit.id, other)] = false;
    }
  }

  void operator()(const LinkAdded& edit) {
    const PlaceLink& link = edit.link;
    require(link.first);
    require(link.second);
    if (link.first == link.second) refuse(inWords(link.first) + " is not linked to itself");
    const Ends ends(link.first, link.second);
    if (link.first > link.second) refuse("the " + inWords(ends) + " has its lower id second");
    const bool is_finite = link.first_from_second.isFinite() &&
                           std::all_of(link.covariance.begin(), link.covariance.end(),
                                       [](double number) { return std::isfinite(number); });
    if (!is_finite) refuse("the pose along the " + inWords(ends) + " is not finite");
    checkDirection(ends, link.forward);
    checkDirection(ends, link.backward);
    links_.insert_or_assign(links_.end(), ends, true);  // a store's links come in their order
  }

  void operator()(const LinkRemoved& edit) {
    const Ends ends = std::minmax(edit.first, edit.second);
    requireLink(ends);
    links_[ends] = false;
  }

  void operator()(const LinkLearned& edit) {
    const Ends ends = std::minmax(edit.from, edit.to);
    requireLink(ends);
    checkDirection(ends, edit.direction);
  }

  void operator()(const MapCleared& /*edit*/) {
    is_cleared_ = true;
    labels_.clear();
    ids_.clear();
    links_.clear();
  }

 private:
  /// How the place will be called, or nullptr where it will not be there.
  const std::string* label(PlaceId id) const {
    const auto changed = labels_.find(id);
    if (changed != labels_.end()) return changed->second.empty() ? nullptr : &changed->second;
    const Place* place = is_cleared_ ? nullptr : map_.find(id);
    return place == nullptr ? nullptr : &place->label;
  }

  PlaceId id(const std::string& label) const {
    const auto changed = ids_.find(label);
    if (changed != ids_.end()) return changed->second;
    const Place* place = is_cleared_ ? nullptr : map_.find(label);
    return place == nullptr ? kNoPlace : place->id;
  }

  const std::string& require(PlaceId id) const {
    const std::string* found = label(id);
    if (found == nullptr) refuse("there is no " + inWords(id) + " in the map");
    return *found;
  }

  void requireLink(const Ends& ends) const {
    const auto changed = links_.find(ends);
    const bool is_there = changed != links_.end()
                              ? changed->second
                              : !is_cleared_ && map_.findLink(ends.first, ends.second) != nullptr;
    if (!is_there) refuse("there is no " + inWords(ends) + " in the map");
  }

  void checkLabel(PlaceId of, const std::string& wanted) const {
    if (!isValidLabel(wanted)) refuse("the label of " + inWords(of) + " is no label");
    if (id(wanted) != kNoPlace) refuse("label \"" + wanted + "\" is in the map already");
  }

  static void checkDirection(const Ends& of, const LinkDirection& direction) {
    for (const double number : {direction.through, direction.blocked, direction.time,
                                direction.time_sigma, direction.lost_time, direction.toll}) {
      if (number >= 0.0 && std::isfinite(number)) continue;
      refuse("what was learned of the " + inWords(of) + " is no number of 0 or more");
    }
  }

  static void checkPose(PlaceId of, const Pose2d& pose) {
    if (!pose.isFinite()) refuse("the location of " + inWords(of) + " is not finite");
  }

  static void checkSession(SessionId session) {
    if (session <= kNoSession) refuse("the number of a session is above 0");
  }

  const PlaceMap& map_;
  bool is_cleared_ = false;                          ///< nothing of map_ counts
  std::unordered_map<PlaceId, std::string> labels_;  ///< of places that changed; "": gone
  std::unordered_map<std::string, PlaceId> ids_;     ///< of labels that changed; kNoPlace: free
  std::map<Ends, bool> links_;                       ///< whether those that changed are there
};

}  // namespace

void checkChange(const PlaceMap& map, const MapChange& change) {
  if (change.version != map.version() + 1) {
    refuse("the change makes version " + std::to_string(change.version) + " of a map of version " +
           std::to_string(map.version()));
  }
  ChangeCheck check(map, change.edits.size());
  for (const MapEdit& edit : change.edits) std::visit(check, edit);
}

}  // namespace place_memory::core
