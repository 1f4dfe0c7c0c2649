#include "rviz/place_list.h"

#include <algorithm>
#include <cstddef>

namespace place_memory::panel {
namespace {

PlaceRow toRow(const Place& place) {
  return {place.id, place.label, place.session, place.location.x, place.location.y};
}

}  // namespace

void PlaceList::reset(const PlaceGraph& graph) {
  places_.clear();
  for (const Place& place : graph.places) places_.emplace(place.id, toRow(place));
  version_ = graph.version;
  rows_ = nullptr;
}

void PlaceList::forget() {
  places_.clear();
  version_.reset();
  rows_ = nullptr;
}

bool PlaceList::apply(const MapChange& change) {
  if (!version_ || change.version > *version_ + 1) return false;
  if (change.version <= *version_) return true;
  doWhatItSays(change);
  version_ = change.version;
  rows_ = nullptr;
  return true;
}

void PlaceList::doWhatItSays(const MapChange& change) {
  if (change.cleared) places_.clear();
  for (const std::int64_t id : change.removed) places_.erase(id);
  for (const Place& place : change.added) places_[place.id] = toRow(place);
  const std::size_t moved =
      std::min({change.moved.size(), change.moved_locations.size(), change.moved_sessions.size()});
  for (std::size_t i = 0; i < moved; ++i) {
    const auto found = places_.find(change.moved[i]);
    if (found == places_.end()) continue;
    found->second.x = change.moved_locations[i].x;
    found->second.y = change.moved_locations[i].y;
    found->second.session = change.moved_sessions[i];
  }
  for (std::size_t i = 0; i < std::min(change.renamed.size(), change.new_labels.size()); ++i) {
    const auto found = places_.find(change.renamed[i]);
    if (found != places_.end()) found->second.label = change.new_labels[i];
  }
}

std::shared_ptr<const PlaceRows> PlaceList::rows() const {
  if (!rows_) {
    PlaceRows rows;
    rows.reserve(places_.size());
    for (const auto& [id, row] : places_) rows.push_back(row);
    rows_ = std::make_shared<const PlaceRows>(std::move(rows));
  }
  return rows_;
}

}  // namespace place_memory::panel
