#include "place_memory/config/match_preset.h"

#include <yaml-cpp/yaml.h>

#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "config/parameter_reader.h"
#include "config/yaml_file.h"
#include "config/yaml_value.h"
#include "embedded_presets.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

constexpr double kLargestWeight = 1000.0;

// Three rows of three numbers; false where the node is anything else.
bool readWeights(const YAML::Node& node, core::PairWeights& weights) {
  if (!node.IsSequence() || node.size() != core::kCellClasses) return false;
  for (std::size_t row = 0; row < core::kCellClasses; ++row) {
    if (!node[row].IsSequence() || node[row].size() != core::kCellClasses) return false;
    for (std::size_t column = 0; column < core::kCellClasses; ++column) {
      const std::optional<double> weight = numberOf(node[row][column]);
      if (!weight || !std::isfinite(*weight) || std::abs(*weight) > kLargestWeight) return false;
      weights[row][column] = *weight;
    }
  }
  return true;
}

/// Takes `key` out of the table and adds a problem where it is no three rows of three numbers.
void takeWeights(YAML::Node& table, const std::string& key, const std::string& where,
                 core::PairWeights& weights, std::vector<std::string>& problems) {
  if (!table[key] || !readWeights(table[key], weights)) {
    problems.push_back(where + ": must be three rows of three numbers, each in [-1000, 1000]");
  }
  table.remove(key);
}

/// What older presets called otherwise, by its path.
struct Renamed {
  std::vector<std::string> was;
  const char* is;
};

std::vector<Renamed> renamedKeys() {
  std::vector<Renamed> renamed{
      {{"turn_cost"}, "rotation_cost"},
      {{"second_look"}, "rescoring"},
      {{"second_look", "first"}, "rescoring/search_score"},
      {{"second_look", "beside"}, "rescoring/peak_sharpness_shift"},
      {{"second_look", "turned"}, "rescoring/peak_sharpness_rotation"},
  };
  for (const char* coefficients : {"right", "known"}) {
    const std::vector<std::pair<const char*, const char*>> features{
        {"lead", "margin"},
        {"prominence", "mean_margin"},
        {"uncontested", "unopposed"},
        {"fewness", "inverse_place_count"}};
    for (const auto& [was, is] : features) {
      renamed.push_back({{"calibration", coefficients, was}, is});
    }
  }
  return renamed;
}

/// Whether the table has what the path names.
bool has(const YAML::Node& table, const std::vector<std::string>& path) {
  YAML::Node node = table;
  for (const std::string& key : path) {
    if (!node.IsMap() || !node[key]) return false;
    node.reset(node[key]);
  }
  return true;
}

/// Throws ParameterError where the table has keys of an older version.
void refuseOldKeys(const YAML::Node& root, const std::string& source) {
  std::vector<std::string> problems;
  for (const Renamed& key : renamedKeys()) {
    if (!has(root, key.was)) continue;
    problems.push_back(boost::algorithm::join(key.was, "/") + " (" + source + "): is called " +
                       key.is + " now; rename it in the file");
  }
  if (!problems.empty()) throw ParameterError(problems);
}

MatchPreset parsePreset(YAML::Node root, const std::string& source) {
  MatchPreset preset;
  std::vector<std::string> problems;
  if (!root.IsMap()) throw ParameterError({source + ": must be a table"});
  refuseOldKeys(root, source);
  takeWeights(root, "weights", "weights (" + source + ")", preset.metric.weights, problems);
  core::RescoringWeights rescoring;
  YAML::Node section = root["rescoring"];
  if (section && section.IsMap()) {
    takeWeights(section, "inner", "rescoring/inner (" + source + ")", rescoring.inner, problems);
    takeWeights(section, "middle", "rescoring/middle (" + source + ")", rescoring.middle, problems);
  }

  ParameterReader reader;
  reader.add(root, source);
  const Interval any{-1000.0, 1000.0, true, true};
  // Half a table would be filled up with numbers that do not belong to it.
  const auto needed = [&](const std::string& name, const Interval& interval, double& value) {
    if (!reader.has(name)) problems.push_back(name + " (" + source + "): is missing");
    reader.number(name, interval, value);
  };
  reader.number("shift_cost", {0.0, 1e6, true, true}, preset.metric.shift_cost);
  reader.flag("overlap_only", preset.metric.overlap_only);
  reader.number("rotation_cost", {0.0, 1e6, true, true}, preset.metric.rotation_cost);
  if (section) {
    needed("rescoring/search_score", {0.0, 1000.0, true, true}, rescoring.search_score);
    for (std::size_t i = 0; i < core::kNearPairs; ++i) {
      needed(std::string("rescoring/") + core::kNearPairsNames[i], any, rescoring.near[i]);
    }
    needed("rescoring/peak_sharpness_shift", any, rescoring.peak_sharpness_shift);
    needed("rescoring/peak_sharpness_rotation", any, rescoring.peak_sharpness_rotation);
    preset.rescoring = rescoring;
  }
  core::Calibration& calibration = preset.calibration;
  needed("calibration/scale", {0.0, 1000.0, false, true}, calibration.scale);
  for (std::size_t i = 0; i < core::kCalibrationFeatureNames.size(); ++i) {
    const std::string name = core::kCalibrationFeatureNames[i];
    for (auto* coefficients : {&calibration.right, &calibration.known}) {
      const std::string key = std::string("calibration/") +
                              (coefficients == &calibration.right ? "right/" : "known/") + name;
      if (i < core::kFirstCalibrationFeatures || reader.has(key)) {
        needed(key, any, (*coefficients)[i]);
      }
    }
  }
  needed("calibration/sharpness", {0.0, 1000.0, true, true}, calibration.sharpness);
  const std::vector<std::string> more = reader.problems();
  problems.insert(problems.end(), more.begin(), more.end());
  if (!problems.empty()) throw ParameterError(problems);
  return preset;
}

}  // namespace

MatchPreset loadPreset(const std::string& name_or_path) {
  if (name_or_path == "evidence") return parsePreset(YAML::Load(kEvidencePreset), "evidence");
  if (name_or_path == "paper") return parsePreset(YAML::Load(kPaperPreset), "paper");
  std::error_code none;
  if (!std::filesystem::exists(name_or_path, none)) {
    throw ParameterError({"match/preset: must be evidence, paper or the path of a file, not '" +
                          support::printable(name_or_path) + "'"});
  }
  return parsePreset(loadYamlFile(name_or_path), name_or_path);
}

}  // namespace place_memory::config
