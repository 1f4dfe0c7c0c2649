#include "place_memory/config/match_preset.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <boost/algorithm/string/replace.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/temporary_folder.h"

namespace place_memory::config {
namespace {

TEST(MatchPreset, PaperIsOnePointForEachPairOfTheSameClass) {
  EXPECT_EQ(loadPreset("paper").metric.weights, core::kPaperWeights);
}

TEST(MatchPreset, BuiltInPresetsAreTheFiles) {
  for (const std::string name : {"evidence", "paper"}) {
    const MatchPreset file =
        loadPreset(PLACE_MEMORY_SOURCE_DIR "/config/presets/" + name + ".yaml");
    const MatchPreset built_in = loadPreset(name);
    EXPECT_EQ(built_in.metric.weights, file.metric.weights) << name;
    EXPECT_EQ(built_in.calibration.scale, file.calibration.scale) << name;
    EXPECT_EQ(built_in.calibration.right, file.calibration.right) << name;
    EXPECT_EQ(built_in.calibration.known, file.calibration.known) << name;
    EXPECT_EQ(built_in.rescoring.has_value(), file.rescoring.has_value()) << name;
  }
}

TEST(MatchPreset, CoefficientsThatWereAddedMayBeMissing) {
  const TemporaryFolder folder;
  const YAML::Node preset = YAML::LoadFile(PLACE_MEMORY_SOURCE_DIR "/config/presets/evidence.yaml");
  for (std::size_t i = core::kFirstCalibrationFeatures; i < core::kCalibrationFeatureNames.size();
       ++i) {
    for (const char* of : {"right", "known"}) {
      YAML::Node coefficients = preset["calibration"][of];
      ASSERT_TRUE(coefficients.remove(core::kCalibrationFeatureNames[i]));
    }
  }
  writeFile(folder.file("old"), YAML::Dump(preset));
  const core::Calibration read = loadPreset(folder.file("old")).calibration;
  const core::Calibration shipped = loadPreset("evidence").calibration;
  for (std::size_t i = 0; i < core::kCalibrationFeatureNames.size(); ++i) {
    const bool added = i >= core::kFirstCalibrationFeatures;
    EXPECT_EQ(read.right[i], added ? 0.0 : shipped.right[i]) << core::kCalibrationFeatureNames[i];
    EXPECT_EQ(read.known[i], added ? 0.0 : shipped.known[i]) << core::kCalibrationFeatureNames[i];
  }
}

/// The shipped preset with one node set anew, or left out.
struct PresetEdit {
  std::vector<std::string> path;
  const char* value;    ///< nullptr: left out
  const char* problem;  ///< begins with what is complained of
};

void PrintTo(const PresetEdit& edit, std::ostream* out) { *out << edit.problem; }

void apply(const PresetEdit& edit, YAML::Node node) {
  for (std::size_t i = 0; i + 1 < edit.path.size(); ++i) node.reset(node[edit.path[i]]);
  if (edit.value == nullptr) {
    node.remove(edit.path.back());
  } else {
    node[edit.path.back()] = YAML::Load(edit.value);
  }
}

class MalformedPreset : public testing::TestWithParam<PresetEdit> {};

TEST_P(MalformedPreset, IsRefusedWithTheReason) {
  const TemporaryFolder folder;
  const YAML::Node preset = YAML::LoadFile(PLACE_MEMORY_SOURCE_DIR "/config/presets/evidence.yaml");
  apply(GetParam(), preset);
  writeFile(folder.file("preset"), YAML::Dump(preset));
  std::vector<std::string> problems{"none"};
  try {
    loadPreset(folder.file("preset"));
  } catch (const ParameterError& error) {
    problems = error.problems();
  }
  const std::string expected = boost::algorithm::replace_all_copy(std::string(GetParam().problem),
                                                                  "FILE", folder.file("preset"));
  EXPECT_EQ(problems.front().find(expected), 0U) << problems.front();
}

INSTANTIATE_TEST_SUITE_P(
    MatchPreset, MalformedPreset,
    testing::Values(PresetEdit{{"weights"}, nullptr, "weights"},
                    PresetEdit{{"weights"}, "1", "weights"},
                    PresetEdit{{"weights"}, "[[1, 0, 0], [0, 1, 0]]", "weights"},
                    PresetEdit{{"weights"}, "[[1, 0], [0, 1], [0, 0]]", "weights"},
                    PresetEdit{{"weights"}, "[[1, 0, x], [0, 1, 0], [0, 0, 1]]", "weights"},
                    PresetEdit{{"weights"}, "[[1, 0, .nan], [0, 1, 0], [0, 0, 1]]", "weights"},
                    PresetEdit{{"weights"}, "[[1, 0, 2000], [0, 1, 0], [0, 0, 1]]", "weights"},
                    PresetEdit{{"shift_cost"}, "-1", "shift_cost"},
                    PresetEdit{{"rotation_cost"}, "many", "rotation_cost"},
                    PresetEdit{{"overlap_only"}, "1", "overlap_only"},
                    PresetEdit{{"calibration"}, nullptr, "calibration/scale"},
                    PresetEdit{{"calibration", "scale"}, nullptr, "calibration/scale"},
                    PresetEdit{{"calibration", "scale"}, "0", "calibration/scale"},
                    PresetEdit{{"calibration", "strangers"}, "1", "calibration/strangers"},
                    PresetEdit{{"calibration", "right"}, "3", "calibration/right"},
                    PresetEdit{{"calibration", "right", "bias"}, nullptr, "calibration/right/bias"},
                    PresetEdit{
                        {"calibration", "known", "margin"}, nullptr, "calibration/known/margin"},
                    PresetEdit{{"calibration", "known", "bias"}, "2000", "calibration/known/bias"},
                    PresetEdit{{"calibration", "sharpness"}, nullptr, "calibration/sharpness"},
                    PresetEdit{{"rescoring"}, "3", "rescoring"},
                    PresetEdit{{"rescoring", "search_score"}, "-1", "rescoring/search_score"},
                    PresetEdit{{"rescoring", "nearest"}, "1", "rescoring/nearest"},
                    PresetEdit{{"rescoring", "inner"}, nullptr, "rescoring/inner"},
                    PresetEdit{{"rescoring", "middle"}, "3", "rescoring/middle"},
                    PresetEdit{{"rescoring", "peak_sharpness_rotation"},
                               nullptr,
                               "rescoring/peak_sharpness_rotation"}));

INSTANTIATE_TEST_SUITE_P(
    OldKeys, MalformedPreset,
    testing::Values(
        PresetEdit{{"turn_cost"}, "1", "turn_cost (FILE): is called rotation_cost now"},
        PresetEdit{{"second_look"}, "{first: 1}", "second_look (FILE): is called rescoring now"},
        PresetEdit{{"calibration", "right", "lead"},
                   "1",
                   "calibration/right/lead (FILE): is called margin now"},
        PresetEdit{{"calibration", "known", "prominence"},
                   "1",
                   "calibration/known/prominence (FILE): is called mean_margin now"},
        PresetEdit{{"calibration", "known", "uncontested"},
                   "1",
                   "calibration/known/uncontested (FILE): is called unopposed now"},
        PresetEdit{{"calibration", "right", "fewness"},
                   "1",
                   "calibration/right/fewness (FILE): is called inverse_place_count now"}));

TEST(MatchPreset, EveryKeyOfAnOlderFileIsNamedWithItsNewName) {
  const TemporaryFolder folder;
  writeFile(folder.file("preset"),
            "second_look: {first: 1, beside: 2, turned: 3}\ncalibration: {known: {lead: 1}}\n");
  try {
    loadPreset(folder.file("preset"));
    ADD_FAILURE() << "it was taken";
  } catch (const ParameterError& error) {
    const std::string what = error.what();
    for (const char* name : {"is called rescoring now", "second_look/first",
                             "rescoring/search_score", "rescoring/peak_sharpness_shift",
                             "rescoring/peak_sharpness_rotation", "calibration/known/lead"}) {
      EXPECT_NE(what.find(name), std::string::npos) << name << " in " << what;
    }
    EXPECT_EQ(error.problems().size(), 5U);
  }
}

TEST(MatchPreset, WhatIsNoTableIsRefused) {
  const TemporaryFolder folder;
  for (const char* text : {"", "[", "evidence"}) {
    writeFile(folder.file("preset"), text);
    EXPECT_THROW(loadPreset(folder.file("preset")), ParameterError) << text;
  }
}

}  // namespace
}  // namespace place_memory::config
