#include "config/yaml_file.h"

#include <gtest/gtest.h>

#include "config/load_parameters.h"
#include "core/temporary_folder.h"
#include "place_memory/config/match_preset.h"
#include "place_memory/config/parameter_error.h"

namespace place_memory::config {
namespace {

/// Parameters of a file with these bytes.
Parameters load(const std::string& bytes) {
  const TemporaryFolder folder;
  writeFile(folder.file("my.yaml"), bytes);
  return loadParameters({folder.file("my.yaml")});
}

std::string problem(const std::string& bytes) {
  try {
    load(bytes);
  } catch (const ParameterError& error) {
    return error.problems().front();
  }
  return "none";
}

TEST(YamlFile, AByteOrderMarkIsNoPartOfTheFirstName) {
  EXPECT_EQ(load("\xef\xbb\xbfscan: {headings: 5}\n").scan.headings, 5);
}

TEST(YamlFile, LinesMayEndAsOnWindows) {
  EXPECT_EQ(load("scan:\r\n  headings: 5\r\n").scan.headings, 5);
}

TEST(YamlFile, CommentsMayBeInAnyLanguage) {
  EXPECT_EQ(load("# K\xc3\xbc"
                 "che\n\t# with a tab\nscan: {headings: 5}\n")
                .scan.headings,
            5);
}

TEST(YamlFile, ADocumentMayBeginWithItsMark) {
  EXPECT_EQ(load("---\nscan: {headings: 5}\n").scan.headings, 5);
}

struct Malformed {
  const char* what;
  std::string bytes;
  const char* problem;  ///< part of it, after the file's name
};

void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.what; }

class MalformedFile : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedFile, IsNamedWithFileAndPlace) {
  const std::string text = problem(GetParam().bytes);
  EXPECT_NE(text.find("my.yaml"), std::string::npos) << text;
  EXPECT_NE(text.find(GetParam().problem), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(
    YamlFile, MalformedFile,
    testing::Values(
        Malformed{"latin-1",
                  "scan: {headings: 5}\n# K\xfc"
                  "che\n",
                  ": line 2: is not UTF-8"},
        Malformed{"utf-16", std::string("\xff\xfes\0c\0a\0n\0", 10), ": is UTF-16"},
        Malformed{"utf-16 without mark", std::string("s\0c\0a\0n\0", 8), ": is UTF-16"},
        Malformed{"tab", "scan:\n\theadings: 5\n", ": line 2: begins with a tab"},
        Malformed{"tab after blanks", "scan:\n  \theadings: 5\n", ": line 2: begins with a tab"},
        Malformed{"two documents", "scan: {headings: 5}\n---\nstore: a\n", ": holds 2 YAML"},
        Malformed{"no YAML", "scan: {headings: 5\nstore: a\n", ": is no YAML"},
        Malformed{"unknown anchor", "scan: *b\n", ": is no YAML"},
        Malformed{"depth", std::string(100000, '['), "more lists and tables"},
        Malformed{"deep list", std::string(5000, ' ') + "- a\n", "line 1: lies too deep"}));

TEST(YamlFile, FilesThatCannotBeReadAreNamedWithTheReason) {
  const TemporaryFolder folder;
  for (const auto& [path, reason] :
       {std::pair<std::string, std::string>{folder.file("none.yaml"), "No such file"},
        {folder.path().string(), "is a folder"}}) {
    try {
      loadYamlFile(path);
      FAIL() << path;
    } catch (const ParameterError& error) {
      EXPECT_EQ(error.problems().front().find(path + ": "), 0U) << error.what();
      EXPECT_NE(error.problems().front().find(reason), std::string::npos) << error.what();
    }
  }
}

TEST(YamlFile, TablesThatContainThemselvesAreNamed) {
  EXPECT_NE(problem("&a\nscan: *a\n").find("scan (/"), std::string::npos);
  EXPECT_NE(
      problem("scan: &a {b: *a, c: *a, d: {e: *a}}\n").find("is a table that contains itself"),
      std::string::npos);
  EXPECT_NE(problem("scan: &a {<<: *a}\n").find("is a table that contains itself"),
            std::string::npos);
  // As a value: no table is looked for in it.
  EXPECT_NE(problem("sonar_topics: &a [sonar, *a]\n").find("must be a list of texts, not a list"),
            std::string::npos);
}

TEST(YamlFile, TablesThatNameEachOtherOverAndOverEnd) {
  for (const char* first : {"{x: 1}", "{}"}) {
    std::string text = std::string("a0: &a0 ") + first + "\n";
    for (int i = 1; i < 60; ++i) {
      const std::string below = "*a" + std::to_string(i - 1);
      text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " {l: " + below +
              ", r: " + below + "}\n";
    }
    EXPECT_NE(problem(text).find("has more parameters than there are"), std::string::npos) << first;
  }
}

TEST(YamlFile, PresetsTakeTheSameCare) {
  const TemporaryFolder folder;
  const std::string path = folder.file("preset.yaml");
  const auto problem_of = [&](const std::string& bytes) -> std::string {
    writeFile(path, bytes);
    try {
      loadPreset(path);
    } catch (const ParameterError& error) {
      return error.problems().front();
    }
    return "none";
  };
  const std::string good = readFile(PLACE_MEMORY_SOURCE_DIR "/config/presets/evidence.yaml");
  EXPECT_EQ(problem_of("\xef\xbb\xbf" + good), "none");
  EXPECT_NE(problem_of(good + "\n---\na: 1\n").find("holds 2 YAML"), std::string::npos);
  EXPECT_NE(problem_of(good + "# \xfc\n").find("is not UTF-8"), std::string::npos);
  EXPECT_NE(problem_of(good + "more: &a {b: *a}\n").find("contains itself"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::config
