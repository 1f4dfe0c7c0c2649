#include "tools/store_source.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "config/memory_options.h"
#include "core/memory/map_export.h"
#include "core/memory/store_merge.h"
#include "core/store/file_header.h"
#include "core/store/store_schema.h"

namespace place_memory::tools {
namespace {

std::string existing(const std::string& path) {
  if (!std::filesystem::exists(path)) throw CommandError("there is no store " + path);
  return path;
}

core::PlaceMemoryOptions optionsOf(const std::string& path, const config::Parameters& parameters) {
  core::PlaceMemoryOptions options = config::memoryOptions(parameters);
  options.store_path = existing(path);
  return options;
}

/// With what it knows: its readings, or where those are not kept the grid alone.
core::Scan scanIn(const std::string& label, const core::PlaceStore& store) {
  const core::PlaceMap map = store.map();
  const core::Place* place = map.find(label);
  if (place == nullptr) throw CommandError(store.path() + " has no place \"" + label + "\"");
  return core::scanOf(*place, store);
}

}  // namespace

StoreSource::StoreSource(const std::string& path, const config::Parameters& parameters)
    : path_(path), parameters_(parameters), memory_(optionsOf(path, parameters)) {}

core::Scan StoreSource::scanOf(const ScanChoice& choice) {
  if (choice.place.empty()) {
    throw CommandError(
        "name the place whose scan it is, with --from FILE where it is in another "
        "store");
  }
  if (!choice.other_store.empty()) {
    return scanIn(choice.place,
                  core::PlaceStore(existing(choice.other_store), parameters_.grid.cell_size));
  }
  const core::MapSnapshot map = memory_.map();
  const auto place = std::find_if(map.places.begin(), map.places.end(), [&](const auto& candidate) {
    return candidate.label == choice.place;
  });
  if (place == map.places.end()) {
    throw CommandError(path_ + " has no place \"" + choice.place + "\"");
  }
  core::Scan scan;
  scan.grid = memory_.grid(place->id);
  scan.odom_from_scan = place->map_from_place;
  scan.robot_in_scan = place->place_from_robot;
  scan.end = place->learned;
  return scan;
}

std::string StoreSource::learn(const std::string& label, const ScanChoice& choice) {
  if (choice.other_store.empty()) {
    throw CommandError(
        "a store learns from another one: name it by --from FILE, or a node by "
        "--node NAME");
  }
  const core::PlaceMemory::Learned learned =
      memory_.learn(scanOf(choice), label.empty() ? choice.place : label, true);
  return "learned \"" + learned.place.label + "\" as place " + std::to_string(learned.place.id) +
         (learned.apart ? "; " + learned.message : "");
}

DrivenGoal StoreSource::go(const std::string& /*label*/, const Progress& /*progress*/) {
  throw CommandError("a file drives no robot: name a node that runs by --node");
}

Recognized StoreSource::recognize(const ScanChoice& choice) {
  const core::PlaceMemory::Answer answer = memory_.recognize(scanOf(choice), std::nullopt);
  const core::Recognition& recognition = answer.recognition;
  Recognized result;
  result.verdict = core::nameOf(recognition.verdict);
  result.map_from_robot = recognition.map_from_robot;
  for (std::size_t i = 0; i < recognition.matches.size(); ++i) {
    const core::PlaceMatch& match = recognition.matches[i];
    result.matches.push_back(
        {answer.labels[i], match.probability, match.score, match.place_from_scan});
  }
  if (recognition.no_echo) result.message = "no echo lies in the scan's grid";
  return result;
}

PlannedRoute StoreSource::plan(const std::string& from, const std::string& to) {
  core::RouteQuery query;
  query.start = core::RouteEnd{core::kNoPlace, from, std::nullopt};
  query.goal.label = to;
  query.second = false;
  const core::RoutePlan found = memory_.plan(query);
  PlannedRoute route;
  route.problem = found.answer.reason;
  for (const core::Place& place : found.best) route.labels.push_back(place.label);
  route.cost = found.answer.best.cost;
  route.odds = found.answer.best.odds;
  return route;
}

std::string StoreSource::exportTo(const std::string& folder) {
  const auto files = core::exportMap(
      memory_.map(), [this](core::PlaceId id) { return memory_.grid(id); },
      parameters_.grid.cell_size, parameters_.sonar.prior, folder);
  return "wrote " + std::to_string(files.size()) + " files into " + folder;
}

std::string StoreSource::merge(const std::string& path, std::vector<std::string>& collisions) {
  const core::MergeReport report = memory_.merge(existing(path));
  for (const auto& collision : report.collisions) {
    collisions.push_back("there is a place \"" + collision.label +
                         "\" already: the new one is called \"" + collision.new_label + "\"");
  }
  return "added " + std::to_string(report.added) + " places, " + std::to_string(report.known) +
         " were known already; of the sessions " + std::to_string(report.joined) +
         " were found in the map, " + std::to_string(report.apart) + " stay apart";
}

std::vector<std::string> checkStore(const std::string& path, const config::Parameters& parameters) {
  core::FileHeader header;
  const bool is_older = header.read(existing(path)) && header.isSqlite() &&
                        header.applicationId() == core::kStoreApplicationId &&
                        header.userVersion() < core::kStoreFormat;
  if (is_older) {
    throw CommandError(path + " has format " + std::to_string(header.userVersion()) +
                       ": it is checked when it is brought to format " +
                       std::to_string(core::kStoreFormat) + ", as by: place_memory list");
  }
  core::StoreOpening opening;
  opening.full_check_size = std::numeric_limits<std::uintmax_t>::max();
  return core::PlaceStore(path, parameters.grid.cell_size, opening).setAside();
}

}  // namespace place_memory::tools
