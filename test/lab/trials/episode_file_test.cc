#include "trials/episode_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace place_memory::trials {
namespace {

const std::string kLearn =
    R"({"role": "learn", "place": "A", "pose": [1, 2, 0.5], "compass": 0.1, "any_heading": false, )"
    R"("ring_radius": 0.2, "fov": 0.4, "r_min": 0.1, "r_max": 3, "cell": 0.06, )"
    R"("readings": [[0, 0.3, 0.02, 1.5], [0, 0.3, 0.02, null], [0, 0.3, 0.02, 9]]})";
const std::string kRecognize =
    R"({"role": "recognize", "accept": ["A"], "pose": [1, 2, 0.5], "compass": 0.1, )"
    R"("any_heading": true, "ring_radius": 0.2, "fov": 0.4, "r_min": 0.1, "r_max": 3, )"
    R"("cell": 0.06, "readings": [[0, 0.3, 0.02, 1.5]]})";

TrialSet read(const std::string& text) {
  const std::string path = testing::TempDir() + "/episodes.jsonl";
  std::ofstream(path) << text;
  return readEpisodeFile(path);
}

std::string problem(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

std::string changed(std::string line, const std::string& from, const std::string& to) {
  const std::size_t at = line.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return line.replace(at, from.size(), to);
}

TEST(EpisodeFile, PutsReadingsIntoTheScanFrame) {
  const TrialSet set = read(kLearn + "\n" + kRecognize + "\n");
  EXPECT_EQ(set.cell_size, 0.06);
  ASSERT_EQ(set.learned.size(), 1U);
  const LearnedScan& scan = set.learned[0];
  EXPECT_EQ(scan.label, "A");
  EXPECT_DOUBLE_EQ(scan.odom_from_scan.x, 1.0);
  EXPECT_DOUBLE_EQ(scan.odom_from_scan.yaw, -0.1) << "compass east lies where the compass errs to";
  ASSERT_EQ(scan.readings.size(), 2U) << "a range beyond the sensor's is no reading";
  const double direction = 0.5 + 0.1 + 0.02 + 0.3;  // heading, its error, turn, bearing
  EXPECT_NEAR(scan.readings[0].sensor_pose.yaw, direction, 1e-12);
  EXPECT_NEAR(scan.readings[0].sensor_pose.x, 0.2 * std::cos(direction), 1e-12);
  EXPECT_EQ(scan.readings[0].range, 1.5);
  EXPECT_TRUE(std::isinf(scan.readings[1].range)) << "null is no echo";
}

TEST(EpisodeFile, ACompassThatSaysNothingOpensTheWindow) {
  const TrialSet set =
      read(kLearn + "\n" + kRecognize + "\n" + changed(kRecognize, "true", "false") + "\n");
  ASSERT_EQ(set.trials.size(), 2U);
  EXPECT_EQ(set.trials[0].accept, std::vector<std::string>{"A"});
  EXPECT_EQ(set.trials[0].heading_window, core::kPi);
  EXPECT_EQ(set.trials[1].heading_window, core::kPi / 4.0);
}

TEST(EpisodeFile, TellsTheWayFromTrialToTrial) {
  const std::string with_way =
      changed(kRecognize, R"("cell")", R"("way": [[0, 2, 0.5], [1, 2, 0.5]], "cell")");
  const TrialSet set = read(kLearn + "\n" + with_way + "\n" + kRecognize + "\n");
  ASSERT_EQ(set.trials[0].way.size(), 2U);
  EXPECT_EQ(set.trials[0].way[0].x, 0.0);
  EXPECT_EQ(set.trials[0].way[1].yaw, 0.5);
  EXPECT_TRUE(set.trials[1].way.empty());
  EXPECT_NE(
      problem(kLearn + "\n" + changed(with_way, "[0, 2, 0.5]", "[0, 2]")).find("a pose of way"),
      std::string::npos);
}

TEST(EpisodeFile, SaysWhichLineIsWrong) {
  EXPECT_NE(problem(kLearn + "\n" + kRecognize + "\n{").find("episodes.jsonl:3: "),
            std::string::npos);
}

struct Malformed {
  const char* from;
  const char* to;
};
void PrintTo(const Malformed& line, std::ostream* output) { *output << line.to; }

class MalformedLine : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedLine, IsRefused) {
  const std::string line = changed(kLearn, GetParam().from, GetParam().to);
  EXPECT_NE(problem(line + "\n" + kRecognize).find("episodes.jsonl:1: "), std::string::npos)
      << problem(line + "\n" + kRecognize);
}

INSTANTIATE_TEST_SUITE_P(
    EpisodeFile, MalformedLine,
    testing::Values(
        Malformed{"\"role\": \"learn\"", "\"role\": \"forget\""},
        Malformed{"\"role\": \"learn\"", "\"role\": 1"},
        Malformed{"\"place\": \"A\"", "\"place\": 7"}, Malformed{"\"place\"", "\"plaice\""},
        Malformed{"[1, 2, 0.5]", "[1, 2]"}, Malformed{"[1, 2, 0.5]", "\"here\""},
        Malformed{"\"compass\": 0.1", "\"compass\": null"}, Malformed{"\"fov\": 0.4", "\"fov\": 0"},
        Malformed{"\"fov\": 0.4", "\"fov\": 4"}, Malformed{"\"r_min\": 0.1", "\"r_min\": -0.1"},
        Malformed{"\"r_max\": 3", "\"r_max\": 0.1"}, Malformed{"\"cell\": 0.06, ", ""},
        Malformed{"[0, 0.3, 0.02, 9]", "[0, 0.3, 0.02]"},
        Malformed{"[0, 0.3, 0.02, 9]", "[0, \"left\", 0.02, 9]"},
        Malformed{"[0, 0.3, 0.02, 9]", "5"}, Malformed{"\"ring_radius\": 0.2, ", ""},
        Malformed{"{", "["}, Malformed{"}", ""}));

/// A line with one field that is wrong, and the error.
struct WrongField {
  const char* from;
  const char* to;
  const char* error;
};
void PrintTo(const WrongField& wrong, std::ostream* output) { *output << wrong.to; }

class WrongEpisode : public testing::TestWithParam<WrongField> {};

TEST_P(WrongEpisode, IsNamedWithLineAndField) {
  const std::string line = changed(kLearn, GetParam().from, GetParam().to);
  const std::string text = problem(line + "\n" + kRecognize);
  EXPECT_NE(text.find(std::string("episodes.jsonl:1: ") + GetParam().error), std::string::npos)
      << text;
}

INSTANTIATE_TEST_SUITE_P(
    EpisodeFile, WrongEpisode,
    testing::Values(
        WrongField{"\"cell\": 0.06", "\"cell\": -1",
                   "cell must be a number in [0.001, 100], not -1"},
        WrongField{"\"cell\": 0.06", "\"cell\": 1e300", "cell must be a number in"},
        WrongField{"\"cell\": 0.06", "\"cell\": \"0.06\"", "cell must be a number in"},
        WrongField{"[1, 2, 0.5]", "[1, 1e300, 0.5]", "pose must be a number in"},
        WrongField{"\"compass\": 0.1", "\"compass\": 1e300", "compass must be a number in"},
        WrongField{"\"ring_radius\": 0.2", "\"ring_radius\": -0.2", "ring_radius must be a number"},
        WrongField{"\"r_max\": 3", "\"r_max\": 1e300", "r_max must be a number in"},
        WrongField{"\"place\": \"A\"", "\"place\": \"\"", "place must not be empty"},
        WrongField{"[[0, 0.3, 0.02, 1.5], [0, 0.3, 0.02, null], [0, 0.3, 0.02, 9]]", "[]",
                   "readings must be a list of one reading or more"},
        WrongField{"[[0, 0.3, 0.02, 1.5], [0, 0.3, 0.02, null], [0, 0.3, 0.02, 9]]",
                   "[[0, 0.3, 0.02, 9]]", "readings must hold one within r_min and r_max"},
        WrongField{"[0, 0.3, 0.02, 9]", "[0, 1e300, 0.02, 9]", "the bearing of a reading must be"},
        WrongField{"[0, 0.3, 0.02, 9]", "[0, 0.3, 1e300, 9]", "the turn of a reading must be"},
        WrongField{"[0, 0.3, 0.02, 9]", "[0, 0.3, 0.02, \"9\"]",
                   "the range of a reading must be"}));

TEST(EpisodeFile, NoPlaceIsLearnedTwice) {
  const std::string text = problem(kLearn + "\n" + kRecognize + "\n" + kLearn + "\n");
  EXPECT_NE(text.find("episodes.jsonl:3: place: 'A' is learned for the second time"),
            std::string::npos)
      << text;
}

TEST(EpisodeFile, WhatIsAcceptedIsLearned) {
  const std::string other = changed(kRecognize, "[\"A\"]", "[\"A\", \"Z\"]");
  const std::string text = problem(kRecognize + "\n" + other + "\n" + kLearn + "\n");
  EXPECT_NE(text.find("episodes.jsonl:2: accept: no line learns 'Z'"), std::string::npos) << text;
  const std::string stranger = changed(kRecognize, "[\"A\"]", "[]");
  EXPECT_EQ(problem(stranger + "\n" + kLearn), "nothing") << "a place never learned";
}

TEST(EpisodeFile, NeedsBothALearnedScanAndATrial) {
  EXPECT_NE(problem(kLearn).find("at least one learn and one recognize"), std::string::npos);
  EXPECT_NE(problem(kRecognize).find("at least one learn and one recognize"), std::string::npos);
  EXPECT_NE(problem("").find("at least one learn and one recognize"), std::string::npos);
}

TEST(EpisodeFile, SaysThatAFileIsNotThere) {
  EXPECT_THROW(readEpisodeFile("/no/such/file.jsonl"), std::runtime_error);
}

TEST(EpisodeFile, RefusesAFileThatIsNotGzippedThoughItsNameSaysSo) {
  const std::string path = testing::TempDir() + "/episodes.jsonl.gz";
  std::ofstream(path) << kLearn;
  EXPECT_THROW(readEpisodeFile(path), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::trials
