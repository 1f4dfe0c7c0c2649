#include "tools/store_reports.h"

#include <filesystem>
#include <optional>
#include <vector>

#include "core/memory/place_changes.h"
#include "core/memory/store_merge.h"
#include "core/memory/twins.h"
#include "tools/map_source.h"

namespace place_memory::tools {
namespace {

/// A store and what matching needs of it.
struct OpenStore {
  core::PlaceStore store;
  core::PlaceMap map;
  core::PlaceIndex index;

  OpenStore(const std::string& path, double cell_size)
      : store(existing(path), cell_size), map(store.map()) {
    store.forEachPlanes(
        [this](core::PlaceId id, const core::CellPlanes& planes) { index.put(id, planes); });
  }

  const std::string& labelOf(core::PlaceId id) const { return map.find(id)->label; }

 private:
  static const std::string& existing(const std::string& path) {
    if (!std::filesystem::exists(path)) throw CommandError("there is no store " + path);
    return path;
  }
};

std::vector<core::PlaceChange> changesOf(const OpenStore& known, const OpenStore& later,
                                         const config::Parameters& parameters) {
  const core::Recognizer recognizer(parameters.match.recognizer);
  const auto frames = [&known](const std::vector<core::PlaceId>& ids) {
    std::vector<core::PlaceFrame> found;
    for (const core::PlaceId id : ids) {
      const core::Place& place = *known.map.find(id);
      found.push_back({place.map_from_place, place.session});
    }
    return std::optional<std::vector<core::PlaceFrame>>(std::move(found));
  };
  std::vector<core::PlaceChange> changes;
  for (const core::Place& place : later.map.places()) {
    const core::Scan scan = core::scanOf(place, later.store);
    const core::Recognition found = *recognizer.recognize(
        scan, known.index, frames, parameters.match.recognizer.heading_window);
    if (found.verdict != core::Verdict::kRecognized || scan.readings.empty()) continue;
    const core::PlaceMatch& match = found.matches.front();
    for (const core::GridChange& change :
         core::changesSeen(known.store, match.id, scan, match.place_from_scan, parameters.sonar)) {
      changes.push_back({match.id, change});
    }
  }
  return changes;
}

}  // namespace

RecordTable twinTable(const std::string& path, const config::Parameters& parameters) {
  const OpenStore known(path, parameters.grid.cell_size);
  core::TwinOptions options;
  options.heading_window = parameters.match.recognizer.heading_window;
  const auto twins = core::findTwins(
      known.map, known.index, core::Recognizer(parameters.match.recognizer),
      [&known](const core::Place& place) { return core::scanOf(place, known.store); }, options);
  RecordTable table({"place", "looks like", "likeness", "differ towards", "at", "scan too at"});
  for (const core::Twin& twin : twins) {
    const double yaw = known.map.find(twin.place)->map_from_place.yaw;
    table.add({known.labelOf(twin.place), known.labelOf(twin.other), Decimal{twin.likeness, 2},
               Decimal{core::wrapAngle(yaw + twin.parting_bearing), 2},
               Decimal{twin.parting_distance, 1},
               twin.parting_place == core::kNoPlace ? std::string("-")
                                                    : known.labelOf(twin.parting_place)});
  }
  return table;
}

RecordTable changeTable(const std::string& path, const std::string& label,
                        const std::string& later_store, const config::Parameters& parameters) {
  const OpenStore known(path, parameters.grid.cell_size);
  if (!label.empty() && known.map.find(label) == nullptr) {
    throw CommandError("there is no place \"" + label + "\"", kNo);
  }
  const auto changes =
      later_store.empty()
          ? core::changesSinceLearned(known.map, known.store, core::SonarModel(parameters.sonar),
                                      parameters.grid)
          : changesOf(known, OpenStore(later_store, parameters.grid.cell_size), parameters);
  RecordTable table({"place", "change", "x", "y", "size"});
  for (const core::PlaceChange& found : changes) {
    const core::Place& place = *known.map.find(found.place);
    if (!label.empty() && place.label != label) continue;
    const core::GridChange& change = found.change;
    const core::Pose2d spot = place.map_from_place * core::Pose2d{change.x, change.y, 0.0};
    table.add({place.label, std::string(change.appeared ? "appeared" : "gone"), Decimal{spot.x, 2},
               Decimal{spot.y, 2}, Decimal{change.size, 2}});
  }
  return table;
}

}  // namespace place_memory::tools
