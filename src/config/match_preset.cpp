#include "place_memory/config/match_preset.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <vector>

#include "embedded_presets.h"
#include "place_memory/config/parameter_reader.h"

namespace place_memory::config {
namespace {

constexpr double kLargestWeight = 1000.0;

// Three rows of three numbers; false where the node is anything else.
bool readWeights(const YAML::Node& node, core::PairWeights& weights) {
  if (!node.IsSequence() || node.size() != core::kCellClasses) return false;
  for (std::size_t row = 0; row < core::kCellClasses; ++row) {
    if (!node[row].IsSequence() || node[row].size() != core::kCellClasses) return false;
    for (std::size_t column = 0; column < core::kCellClasses; ++column) {
      double& weight = weights[row][column];
      if (!YAML::convert<double>::decode(node[row][column], weight)) return false;
      if (!std::isfinite(weight) || std::abs(weight) > kLargestWeight) return false;
    }
  }
  return true;
}

MatchPreset parsePreset(YAML::Node root, const std::string& source) {
  MatchPreset preset;
  std::vector<std::string> problems;
  if (!root.IsMap()) throw ParameterError({source + ": must be a table"});
  if (!root["weights"] || !readWeights(root["weights"], preset.weights)) {
    problems.push_back("weights (" + source +
                       "): must be three rows of three numbers, each in [-1000, 1000]");
  }
  if (!root["calibration"]) problems.push_back("calibration (" + source + "): is missing");

  root.remove("weights");
  ParameterReader reader;
  reader.add(root, source);
  reader.number("calibration/scale", {0.0, 1000.0, false, true}, preset.calibration.scale);
  reader.number("calibration/stranger", {-1e7, 1e7, true, true}, preset.calibration.stranger);
  const std::vector<std::string> more = reader.problems();
  problems.insert(problems.end(), more.begin(), more.end());
  if (!problems.empty()) throw ParameterError(problems);
  return preset;
}

}  // namespace

MatchPreset loadPreset(const std::string& name_or_path) {
  try {
    if (name_or_path == "evidence") return parsePreset(YAML::Load(kEvidencePreset), "evidence");
    if (name_or_path == "paper") return parsePreset(YAML::Load(kPaperPreset), "paper");
    return parsePreset(YAML::LoadFile(name_or_path), name_or_path);
  } catch (const YAML::BadFile&) {
    throw ParameterError(
        {"match/preset: must be evidence, paper or the path of a file that can be "
         "read, not '" +
         name_or_path + "'"});
  } catch (const YAML::Exception& error) {
    throw ParameterError({name_or_path + ": " + error.what()});
  }
}

}  // namespace place_memory::config
