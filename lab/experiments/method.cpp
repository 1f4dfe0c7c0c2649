#include "experiments/method.h"

#include <algorithm>
#include <stdexcept>

#include "config/load_parameters.h"

namespace place_memory::experiments {
namespace {

/// What a method changes of the default; empty: nothing.
struct Variant {
  const char* name;
  const char* title;
  const char* preset;
  const char* search;
  Sensor sensor;
  bool slow;
};

constexpr Variant kVariants[] = {
    {"nearest_neighbour", "nearest neighbour", "paper", "nearest_neighbour", Sensor::kSonar, false},
    {"hill_climbing", "paper's hill climbing", "paper", "hill_climbing", Sensor::kSonar, false},
    {"hill_climbing_restarts", "paper's, restarts", "paper", "restarts", Sensor::kSonar, false},
    {"default", "default", "", "", Sensor::kSonar, false},
    {"default_single_climb", "default, single climb", "", "hill_climbing", Sensor::kSonar, false},
    {"default_exhaustive", "default, exhaustive", "", "exhaustive", Sensor::kSonar, true},
    {"hill_climbing_laser", "paper's, laser", "paper", "hill_climbing", Sensor::kLaser, false},
    {"default_laser", "default, laser", "", "", Sensor::kLaser, false},
};

void layOver(YAML::Node below, const YAML::Node& above) {
  for (const auto& entry : above) {
    const auto key = entry.first.as<std::string>();
    if (entry.second.IsMap() && below[key] && below[key].IsMap()) {
      layOver(below[key], entry.second);
    } else {
      below[key] = YAML::Clone(entry.second);
    }
  }
}

YAML::Node mergedFiles(const std::vector<std::string>& files) {
  config::loadParameters(files);  // names the file where something is wrong with one
  YAML::Node merged(YAML::NodeType::Map);
  for (const std::string& file : files) layOver(merged, YAML::LoadFile(file));
  return merged;
}

}  // namespace

std::vector<Method> allMethods(const std::vector<std::string>& parameter_files,
                               const std::string& preset) {
  YAML::Node base = mergedFiles(parameter_files);
  if (!preset.empty()) base["match"]["preset"] = preset;
  std::vector<Method> methods;
  for (const Variant& variant : kVariants) {
    YAML::Node table = YAML::Clone(base);
    if (*variant.preset != '\0') table["match"]["preset"] = variant.preset;
    if (*variant.search != '\0') table["match"]["method"] = variant.search;
    methods.push_back({variant.name, variant.title, variant.sensor, variant.slow,
                       config::parseParameters(table, variant.name)});
  }
  return methods;
}

std::vector<Method> selectMethods(const std::vector<Method>& methods,
                                  const std::vector<std::string>& names) {
  if (names.empty()) return methods;
  std::vector<Method> selected;
  for (const std::string& name : names) {
    const auto it = std::find_if(methods.begin(), methods.end(),
                                 [&](const Method& method) { return method.name == name; });
    if (it == methods.end()) throw std::runtime_error("'" + name + "' is not a method");
    selected.push_back(*it);
  }
  return selected;
}

}  // namespace place_memory::experiments
