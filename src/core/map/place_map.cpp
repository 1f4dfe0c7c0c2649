#include "place_memory/core/place_map.h"

#include <algorithm>
#include <utility>

#include "core/map/change_check.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {
namespace {

template <class Container>
void insertSorted(Container& container, const typename Container::value_type& value) {
  container.insert(std::lower_bound(container.begin(), container.end(), value), value);
}

}  // namespace

/// Makes edits that were checked.
class PlaceMap::Editor {
 public:
  explicit Editor(PlaceMap& map) : map_(map) {}

  void operator()(const PlaceAdded& edit) {
    const auto at = map_.places_.begin() + static_cast<std::ptrdiff_t>(map_.indexOf(edit.place.id));
    map_.places_.insert(at, edit.place);
    map_.id_of_label_.emplace(edit.place.label, edit.place.id);
  }

  void operator()(const PlaceMoved& edit) {
    Place& place = at(edit.id);
    place.map_from_place = edit.map_from_place;
    place.session = edit.session;
  }

  void operator()(const PlaceRenamed& edit) {
    Place& place = at(edit.id);
    map_.id_of_label_.erase(place.label);
    place.label = edit.label;
    map_.id_of_label_.emplace(edit.label, edit.id);
  }

  void operator()(const GridAdapted& /*edit*/) {}

  void operator()(const PlaceRemoved& edit) {
    for (const PlaceId other : map_.neighbours(edit.id)) unlink(edit.id, other);
    const auto place = map_.places_.begin() + static_cast<std::ptrdiff_t>(map_.indexOf(edit.id));
    map_.id_of_label_.erase(place->label);
    map_.places_.erase(place);
  }

  void operator()(const LinkAdded& edit) {
    const PlaceLink& link = edit.link;
    if (!map_.links_.insert_or_assign({link.first, link.second}, link).second) return;
    insertSorted(map_.neighbours_[link.first], link.second);
    insertSorted(map_.neighbours_[link.second], link.first);
  }

  void operator()(const LinkRemoved& edit) { unlink(edit.first, edit.second); }

  void operator()(const LinkLearned& edit) {
    PlaceLink& link = map_.links_.at(std::minmax(edit.from, edit.to));
    (edit.from == link.first ? link.forward : link.backward) = edit.direction;
  }

  void operator()(const MapCleared& /*edit*/) {
    map_.places_.clear();
    map_.id_of_label_.clear();
    map_.links_.clear();
    map_.neighbours_.clear();
  }

 private:
  Place& at(PlaceId id) { return map_.places_[map_.indexOf(id)]; }

  void unlink(PlaceId one, PlaceId other) {
    map_.links_.erase(std::minmax(one, other));
    forget(one, other);
    forget(other, one);
  }

  void forget(PlaceId at, PlaceId neighbour) {
    const auto found = map_.neighbours_.find(at);
    std::vector<PlaceId>& all = found->second;
    all.erase(std::lower_bound(all.begin(), all.end(), neighbour));
    if (all.empty()) map_.neighbours_.erase(found);
  }

  PlaceMap& map_;
};

PlaceMap::PlaceMap(std::vector<Place> places, const std::vector<PlaceLink>& links,
                   std::uint64_t version, std::chrono::nanoseconds stamp) {
  MapChange change;
  change.version = 1;
  change.edits.reserve(places.size() + links.size());
  places_.reserve(places.size());
  id_of_label_.reserve(places.size());
  neighbours_.reserve(places.size());
  for (Place& place : places) change.edits.emplace_back(PlaceAdded{std::move(place), {}, {}});
  for (const PlaceLink& link : links) change.edits.emplace_back(LinkAdded{link});
  apply(change);
  version_ = version;
  stamp_ = stamp;
}

const Place* PlaceMap::find(PlaceId id) const {
  const std::size_t at = indexOf(id);
  return at < places_.size() && places_[at].id == id ? &places_[at] : nullptr;
}

const Place* PlaceMap::find(const std::string& label) const {
  const auto found = id_of_label_.find(label);
  return found == id_of_label_.end() ? nullptr : find(found->second);
}

const PlaceLink* PlaceMap::findLink(PlaceId one, PlaceId other) const {
  const auto found = links_.find(std::minmax(one, other));
  return found == links_.end() ? nullptr : &found->second;
}

std::vector<PlaceLink> PlaceMap::links() const {
  std::vector<PlaceLink> links;
  links.reserve(links_.size());
  for (const auto& [ends, link] : links_) links.push_back(link);
  return links;
}

void PlaceMap::forEachLink(const std::function<void(const PlaceLink&)>& call) const {
  for (const auto& [ends, link] : links_) call(link);
}

std::vector<PlaceId> PlaceMap::neighbours(PlaceId id) const {
  const auto found = neighbours_.find(id);
  return found == neighbours_.end() ? std::vector<PlaceId>() : found->second;
}

void PlaceMap::check(const MapChange& change) const { checkChange(*this, change); }

void PlaceMap::apply(const MapChange& change) {
  check(change);
  Editor editor(*this);
  for (const MapEdit& edit : change.edits) std::visit(editor, edit);
  version_ = change.version;
  stamp_ = change.stamp;
}

std::size_t PlaceMap::indexOf(PlaceId id) const {
  // Most places that are asked for to be added come behind all others.
  if (places_.empty() || places_.back().id < id) return places_.size();
  const auto found =
      std::lower_bound(places_.begin(), places_.end(), id,
                       [](const Place& place, PlaceId key) { return place.id < key; });
  return static_cast<std::size_t>(found - places_.begin());
}

}  // namespace place_memory::core
