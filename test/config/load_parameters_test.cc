#include "config/load_parameters.h"

#include <gtest/gtest.h>

#include "config/parameter_reader.h"
#include "config/parsed_parameters.h"
#include "core/temporary_folder.h"
#include "place_memory/config/match_preset.h"

namespace place_memory::config {
namespace {

const std::string kDefaults = PLACE_MEMORY_SOURCE_DIR "/config/place_memory.yaml";

void collectNames(const YAML::Node& node, const std::string& name, std::set<std::string>& names) {
  if (!node.IsMap()) {
    names.insert(name);
    return;
  }
  for (const auto& item : node) {
    const std::string prefix = name.empty() ? "" : name + "/";
    collectNames(item.second, prefix + item.first.as<std::string>(), names);
  }
}

void expectSame(const Parameters& a, const Parameters& b) {
  EXPECT_EQ(a.odom_frame, b.odom_frame);
  EXPECT_EQ(a.base_frame, b.base_frame);
  EXPECT_EQ(a.map_frame, b.map_frame);
  EXPECT_EQ(a.tf_broadcast, b.tf_broadcast);
  EXPECT_EQ(a.sonar_topics, b.sonar_topics);
  EXPECT_EQ(a.heading_topic, b.heading_topic);
  EXPECT_EQ(a.store, b.store);
  EXPECT_NEAR(a.grid.cell_size, b.grid.cell_size, 1e-9);
  EXPECT_EQ(a.sonar.prior, b.sonar.prior);
  EXPECT_EQ(a.sonar.occupied, b.sonar.occupied);
  EXPECT_EQ(a.sonar.empty, b.sonar.empty);
  EXPECT_EQ(a.sonar.echo_depth, b.sonar.echo_depth);
  EXPECT_EQ(a.scan.headings, b.scan.headings);
  EXPECT_NEAR(a.scan.step, b.scan.step, 1e-6);
  EXPECT_EQ(a.scan.turn, b.scan.turn);
  EXPECT_EQ(a.scan.turn_rate, b.scan.turn_rate);
  EXPECT_EQ(a.scan.timeout, b.scan.timeout);
  EXPECT_EQ(a.scan.min_readings, b.scan.min_readings);
  EXPECT_EQ(a.scan.tf_timeout, b.scan.tf_timeout);
  EXPECT_EQ(a.scan.heading_timeout, b.scan.heading_timeout);
  EXPECT_EQ(a.scan.max_age, b.scan.max_age);
  EXPECT_EQ(a.scan.over_range_is_no_echo, b.scan.over_range_is_no_echo);
  EXPECT_EQ(a.scan.zero_range_is_no_echo, b.scan.zero_range_is_no_echo);
  EXPECT_EQ(a.match.preset, b.match.preset);
  EXPECT_EQ(a.match.recognizer.method, b.match.recognizer.method);
  EXPECT_EQ(a.match.recognizer.position_window, b.match.recognizer.position_window);
  EXPECT_EQ(a.match.recognizer.confidence, b.match.recognizer.confidence);
  EXPECT_EQ(a.match.recognizer.threads, b.match.recognizer.threads);
  EXPECT_EQ(a.match.recognizer.metric.weights, b.match.recognizer.metric.weights);
  EXPECT_NEAR(a.match.recognizer.heading_window, b.match.recognizer.heading_window, 1e-6);
  EXPECT_EQ(a.places.enabled, b.places.enabled);
  EXPECT_EQ(a.places.retention, b.places.retention);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.tf_rate, b.tf_rate);
  EXPECT_EQ(a.transform_tolerance, b.transform_tolerance);
  EXPECT_EQ(a.drive.correct, b.drive.correct);
  EXPECT_EQ(a.drive.largest_jump, b.drive.largest_jump);
  EXPECT_EQ(a.drive.initialpose, b.drive.initialpose);
  EXPECT_EQ(a.markers.labels, b.markers.labels);
  EXPECT_EQ(a.markers.clickable, b.markers.clickable);
  EXPECT_EQ(a.map.resolution, b.map.resolution);
  EXPECT_EQ(a.map.max_cells, b.map.max_cells);
  EXPECT_EQ(a.map.occupied, b.map.occupied);
  EXPECT_EQ(a.map.empty, b.map.empty);
  EXPECT_EQ(a.map.pause, b.map.pause);
}

TEST(LoadParameters, FileOfDefaultsHoldsTheDefaults) {
  const Parameters defaults = loadParameters({});
  expectSame(loadParameters({kDefaults}), defaults);

  // Those of the struct, but for the preset, which only the parser loads.
  Parameters bare;
  bare.match.recognizer.metric.weights = loadPreset("evidence").metric.weights;
  expectSame(defaults, bare);
}

TEST(LoadParameters, FileOfDefaultsHasEveryParameter) {
  std::set<std::string> in_file;
  collectNames(YAML::LoadFile(kDefaults), "", in_file);
  EXPECT_EQ(in_file, parameterNames());
}

TEST(LoadParameters, TakesGivenValuesAndLeavesTheOthers) {
  const Parameters p = parse(R"(
odom_frame: ""
sonar_topics: [front, /robot/rear]
grid: {cell_size: 0.06}
scan: {headings: 73, turn: cmd_vel, over_range_is_no_echo: true}
match: {preset: paper, method: nearest_neighbour}
)");
  EXPECT_EQ(p.odom_frame, "");
  EXPECT_EQ(p.sonar_topics, (std::vector<std::string>{"front", "/robot/rear"}));
  EXPECT_EQ(p.grid.cell_size, 0.06);
  EXPECT_EQ(p.scan.headings, 73);
  EXPECT_EQ(p.scan.turn, Turn::kCmdVel);
  EXPECT_TRUE(p.scan.over_range_is_no_echo);
  EXPECT_EQ(p.match.recognizer.method, core::SearchMethod::kNearestNeighbour);
  EXPECT_EQ(p.match.recognizer.metric.weights, core::kPaperWeights);
  EXPECT_EQ(p.base_frame, "base_link");
  EXPECT_EQ(p.scan.min_readings, Parameters().scan.min_readings);
}

TEST(LoadParameters, TheModeMayBeABareOffWhichYamlTakesForFalse) {
  EXPECT_EQ(parse("mode: map\n").mode, Mode::kMap);
  EXPECT_EQ(parse("mode: off\n").mode, Mode::kOff);
  EXPECT_EQ(parse("mode: \"off\"\n").mode, Mode::kOff);
  EXPECT_THROW(parse("mode: on\n"), ParameterError);
  EXPECT_THROW(parse("mode: drive\n"), ParameterError);
  EXPECT_THROW(parse("mode: map\nodom_frame: \"\"\n"), ParameterError);
}

TEST(LoadParameters, LaterFilesWin) {
  const TemporaryFolder folder;
  writeFile(folder.file("a"), "grid: {cell_size: 0.1}\nscan: {headings: 5, min_readings: 3}\n");
  writeFile(folder.file("b"), "scan: {headings: 7}\n");
  const Parameters p = loadParameters({folder.file("a"), folder.file("b")});
  EXPECT_EQ(p.grid.cell_size, 0.1);
  EXPECT_EQ(p.scan.headings, 7);
  EXPECT_EQ(p.scan.min_readings, 3);
}

TEST(LoadParameters, EmptyFilesAndSectionsChangeNothing) {
  EXPECT_NO_THROW(expectSame(parse(""), parse("scan:\nmatch:\n")));
}

TEST(LoadParameters, ListsEveryProblemAtOnce) {
  const auto problems = problemsOf(
      "grid: {cell_size: -1}\nscan: {headings: many, stepp: 0.1}\nmatch: {preset: "
      "/no/such/file}\n");
  EXPECT_EQ(problems.size(), 4U);
}

TEST(LoadParameters, UnreadableFilesAreNamed) {
  const TemporaryFolder folder;
  const std::string broken = folder.file("broken");
  writeFile(broken, "scan: [");
  try {
    loadParameters({"/no/such/file.yaml", broken});
    FAIL() << "expected a ParameterError";
  } catch (const ParameterError& error) {
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_NE(error.problems()[0].find("/no/such/file.yaml"), std::string::npos);
    EXPECT_NE(error.problems()[1].find(broken), std::string::npos);
  }
}

TEST(LoadParameters, NumbersAreReadAsRoslaunchReadsThem) {
  EXPECT_DOUBLE_EQ(parse("scan: {step: 1e-2}").scan.step, 0.01);
  EXPECT_DOUBLE_EQ(parse("scan: {step: deg(2)}").scan.step, core::kPi / 90.0);
  EXPECT_DOUBLE_EQ(parse("scan: {step: rad(pi/90)}").scan.step, core::kPi / 90.0);
  EXPECT_EQ(parse("scan: {headings: 010}").scan.headings, 8);
  EXPECT_EQ(parse("scan: {timeout: 1:30}").scan.timeout, 90.0);
  EXPECT_EQ(parse("scan: {timeout: 30}").scan.timeout, 30.0);
  EXPECT_TRUE(parse("places: {adapt: yes}").places.enabled);
  EXPECT_EQ(parse("map_frame: y").map_frame, "y");
  EXPECT_EQ(parse("map_frame: 1e-2").map_frame, "1e-2");
}

TEST(LoadParameters, TablesMergeAsRoslaunchMergesThem) {
  const Parameters p = parse(R"(
scan: &slow {timeout: 100, headings: 5}
<<: {map_frame: world, scan: {headings: 7}}
match: {<<: [{confidence: 0.9}, {confidence: 0.7, position_window: 2}]}
)");
  EXPECT_EQ(p.map_frame, "world");
  EXPECT_EQ(p.scan.headings, 5) << "what stands in the table itself holds";
  EXPECT_EQ(p.match.recognizer.confidence, 0.9) << "and the first of several";
  EXPECT_EQ(p.match.recognizer.position_window, 2.0);
}

TEST(ParameterReader, AnOldNameNamesTheNewOne) {
  ParameterReader reader;
  reader.renamed({{"scan/angle", "scan/step"}});
  reader.add(YAML::Load("scan: {angle: 0.1}"), "test");
  double step = 0.0;
  reader.number("scan/step", {0.0, 1.0}, step);
  EXPECT_EQ(reader.problems(),
            (std::vector<std::string>{"scan/angle (test): is called scan/step now"}));
  EXPECT_EQ(step, 0.0) << "the old name sets nothing";
}

TEST(LoadParameters, ThreadsBoundThePoolOfMatching) {
  EXPECT_EQ(parse("match: {threads: 256}").match.recognizer.threads, 256U);
  EXPECT_EQ(parse("").match.recognizer.threads, 0U);
}

TEST(LoadParameters, LeadingSlashesOfFramesAreTakenOff) {
  const Parameters p = parse("{odom_frame: /odom, base_frame: //base, map_frame: /map}");
  EXPECT_EQ(p.odom_frame, "odom");
  EXPECT_EQ(p.base_frame, "base");
  EXPECT_EQ(p.map_frame, "map");
}

TEST(LoadParameters, MountsAreAListOfPoses) {
  const Parameters p = parse("cloud: {mounts: [[0.1, 0, deg(90)], [0, 1, -1]]}");
  ASSERT_EQ(p.cloud.mounts.size(), 2U);
  EXPECT_DOUBLE_EQ(p.cloud.mounts[0].yaw, core::kPi / 2);
  EXPECT_EQ(p.cloud.mounts[1].y, 1.0);
  EXPECT_TRUE(parse("cloud: {mounts: []}").cloud.mounts.empty());
}

TEST(LoadParameters, WithoutACompassAnyHeadingIsSought) {
  const Parameters p = parse("{heading_topic: '', match: {heading_window: 0.3}}");
  EXPECT_EQ(p.match.recognizer.heading_window, core::kPi);
}

TEST(LoadParameters, WithoutOdometryPlacesHaveNoLocation) {
  EXPECT_TRUE(parse("odom_frame: odom").match.recognizer.located);
  EXPECT_FALSE(parse("odom_frame: ''").match.recognizer.located);
}

TEST(LoadParameters, TheBuildingsMapHasBounds) {
  EXPECT_EQ(parse("map: {resolution: 0.1, max_cells: 5000000}").map.max_cells, 5000000);
  for (const char* text : {"map: {resolution: 0}", "map: {resolution: 2}", "map: {max_cells: 1000}",
                           "map: {occupied: 1.5}", "map: {pause: 0}"}) {
    EXPECT_EQ(problemsOf(text).size(), 1U) << text;
  }
  EXPECT_EQ(problemsOf("map: {occupied: 0.3, empty: 0.4}"),
            (std::vector<std::string>{"map/empty: must be below map/occupied"}));
}

}  // namespace
}  // namespace place_memory::config
