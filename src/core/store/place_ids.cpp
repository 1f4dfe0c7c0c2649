#include "core/store/place_ids.h"

#include <algorithm>
#include <unordered_set>
#include <variant>

namespace place_memory::core {

std::vector<PlaceId> idsOf(const std::vector<Place>& places) {
  std::vector<PlaceId> ids;
  ids.reserve(places.size());
  for (const Place& place : places) ids.push_back(place.id);
  return ids;
}

void follow(const MapChange& change, std::vector<PlaceId>& ids) {
  std::unordered_set<PlaceId> removed;
  for (const MapEdit& edit : change.edits) {
    if (const auto* place = std::get_if<PlaceAdded>(&edit)) {
      removed.erase(place->place.id);
      ids.push_back(place->place.id);
    } else if (const auto* gone = std::get_if<PlaceRemoved>(&edit)) {
      removed.insert(gone->id);
    } else if (std::holds_alternative<MapCleared>(edit)) {
      ids.clear();
      removed.clear();
    }
  }
  if (!removed.empty()) {
    ids.erase(std::remove_if(ids.begin(), ids.end(),
                             [&removed](PlaceId id) { return removed.count(id) > 0; }),
              ids.end());
  }
  if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace place_memory::core
