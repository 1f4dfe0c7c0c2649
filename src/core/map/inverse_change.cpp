#include "core/map/inverse_change.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <variant>

namespace place_memory::core {
namespace {

using Ends = std::pair<PlaceId, PlaceId>;

/// Notes what each edit touches, and what of it is there after all of them.
class TouchedParts {
 public:
  explicit TouchedParts(const PlaceMap& before) : before_(before) {}

  void operator()(const PlaceAdded& edit) { places_[edit.place.id] = true; }
  void operator()(const PlaceMoved& edit) { moved_.insert(edit.id); }
  void operator()(const PlaceRenamed& edit) { renamed_.insert(edit.id); }
  void operator()(const GridAdapted& edit) { adapted_.insert(edit.id); }
  void operator()(const PlaceRemoved& edit) {
    places_[edit.id] = false;
    for (const PlaceId other : before_.neighbours(edit.id)) {
      links_[std::minmax(edit.id, other)] = false;
    }
    for (auto& [ends, is_there] : links_) {
      if (ends.first == edit.id || ends.second == edit.id) is_there = false;
    }
  }
  void operator()(const LinkAdded& edit) { links_[{edit.link.first, edit.link.second}] = true; }
  void operator()(const LinkRemoved& edit) { links_[std::minmax(edit.first, edit.second)] = false; }
  void operator()(const LinkLearned& edit) { links_[std::minmax(edit.from, edit.to)] = true; }
  void operator()(const MapCleared& /*edit*/) {
    for (auto& [id, is_there] : places_) is_there = false;
    for (auto& [ends, is_there] : links_) is_there = false;
    for (const Place& place : before_.places()) places_[place.id] = false;
    for (const PlaceLink& link : before_.links()) links_[{link.first, link.second}] = false;
  }

  /// Those that have to go.
  std::vector<PlaceId> added() const {
    std::vector<PlaceId> ids;
    for (const auto& [id, is_there] : places_) {
      if (is_there) ids.push_back(id);
    }
    return ids;
  }
  /// Those that have to come back.
  std::vector<PlaceId> gone() const {
    std::vector<PlaceId> ids;
    for (const auto& [id, is_there] : places_) {
      if (before_.find(id) != nullptr) ids.push_back(id);
    }
    return ids;
  }
  std::vector<PlaceId> moved() const { return staying(moved_); }
  std::vector<PlaceId> renamed() const { return staying(renamed_); }
  std::vector<PlaceId> adapted() const { return staying(adapted_); }
  const std::map<Ends, bool>& links() const { return links_; }
  bool stays(PlaceId id) const { return before_.find(id) != nullptr && places_.count(id) == 0; }

 private:
  std::vector<PlaceId> staying(const std::set<PlaceId>& ids) const {
    std::vector<PlaceId> all;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(all),
                 [this](PlaceId id) { return stays(id); });
    return all;
  }

  const PlaceMap& before_;
  std::map<PlaceId, bool> places_;  ///< that came or went, and whether they are there afterwards
  std::set<PlaceId> moved_;
  std::set<PlaceId> renamed_;
  std::set<PlaceId> adapted_;
  std::map<Ends, bool> links_;
};

}  // namespace

std::optional<std::vector<MapEdit>> inverseOf(const std::vector<MapEdit>& edits,
                                              const PlaceMap& before, const PlaceContents& contents,
                                              std::size_t most_bytes) {
  TouchedParts touched(before);
  for (const MapEdit& edit : edits) std::visit(touched, edit);
  std::vector<MapEdit> inverse;
  for (const PlaceId id : touched.added()) inverse.emplace_back(PlaceRemoved{id});
  // Before places come back, so that their labels are free.
  for (const PlaceId id : touched.renamed()) {
    inverse.emplace_back(PlaceRenamed{id, before.find(id)->label});
  }
  std::size_t bytes = 0;
  const auto fits = [&](std::size_t more) { return (bytes += more) <= most_bytes; };
  for (const PlaceId id : touched.gone()) {
    auto readings = std::make_shared<const std::vector<SonarReading>>(contents.readings(id));
    if (!fits(kGridCells + readings->size() * sizeof(SonarReading))) return std::nullopt;
    inverse.emplace_back(PlaceAdded{*before.find(id),
                                    std::make_shared<const EvidenceGrid>(contents.grid(id)),
                                    std::move(readings)});
  }
  for (const PlaceId id : touched.moved()) {
    const Place& place = *before.find(id);
    inverse.emplace_back(PlaceMoved{id, place.map_from_place, place.session});
  }
  for (const PlaceId id : touched.adapted()) {
    if (!fits(kGridCells)) return std::nullopt;
    inverse.emplace_back(GridAdapted{id, std::make_shared<const EvidenceGrid>(contents.grid(id))});
  }
  for (const auto& [ends, is_there] : touched.links()) {
    const PlaceLink* link = before.findLink(ends.first, ends.second);
    if (link != nullptr) {
      inverse.emplace_back(LinkAdded{*link});
    } else if (is_there && touched.stays(ends.first) && touched.stays(ends.second)) {
      inverse.emplace_back(LinkRemoved{ends.first, ends.second});
    }
  }
  return inverse;
}

}  // namespace place_memory::core
