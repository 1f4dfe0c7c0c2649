#include "node/parameter_server.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue table(const std::string& section, const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue result;
  result[section][name] = value;
  return result;
}

config::Parameters parse(const XmlRpcValue& value) {
  return config::parseParameters(toYaml(value), "test");
}

TEST(ToYaml, NumbersAreWhatTheyWere) {
  const double size = 0.1 + 1e-12;
  EXPECT_EQ(parse(table("grid", "cell_size", size)).grid.cell_size, size);
  EXPECT_EQ(parse(table("grid", "cell_size", 1)).grid.cell_size, 1.0);
  EXPECT_EQ(parse(table("scan", "headings", 5)).scan.headings, 5);
}

TEST(ToYaml, FlagsAndTextsAreWhatTheyWere) {
  EXPECT_TRUE(parse(table("scan", "over_range_is_no_echo", true)).scan.over_range_is_no_echo);
  EXPECT_EQ(parse(table("match", "preset", "paper")).match.preset, "paper");
  XmlRpcValue frame;
  frame["map_frame"] = "5";
  EXPECT_EQ(parse(frame).map_frame, "5");
}

TEST(ToYaml, ListsAreWhatTheyWere) {
  XmlRpcValue topics;
  topics["sonar_topics"][0] = "a";
  topics["sonar_topics"][1] = "b";
  EXPECT_EQ(parse(topics).sonar_topics, (std::vector<std::string>{"a", "b"}));
}

TEST(ToYaml, NothingIsTurnedIntoAnotherType) {
  EXPECT_THROW(parse(table("grid", "cell_size", "0.1")), config::ParameterError);
  EXPECT_THROW(parse(table("grid", "cell_size", true)), config::ParameterError);
  EXPECT_THROW(parse(table("scan", "over_range_is_no_echo", "true")), config::ParameterError);
  EXPECT_THROW(parse(table("scan", "over_range_is_no_echo", 1)), config::ParameterError);
  EXPECT_THROW(parse(table("match", "preset", 5)), config::ParameterError);
}

std::string problemOf(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue table;
  table[name] = value;
  try {
    parse(table);
  } catch (const config::ParameterError& error) {
    return error.problems().front();
  }
  return "none";
}

TEST(ToYaml, NumbersThatRoslaunchTakesForTextsAreNumbers) {
  EXPECT_EQ(parse(table("scan", "step", "1e-2")).scan.step, 0.01);
  EXPECT_DOUBLE_EQ(parse(table("scan", "step", "deg(2)")).scan.step, M_PI / 90.0);
  EXPECT_DOUBLE_EQ(parse(table("scan", "step", "pi/90")).scan.step, M_PI / 90.0);
}

TEST(ToYaml, ANumberThatIsNoneIsNoName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(problemOf("map_frame", nan).find("must be a text, not '.nan'"), std::string::npos);
  EXPECT_NE(problemOf("map_frame", INFINITY).find("must be a text"), std::string::npos);
}

TEST(ToYaml, DatesAndBinaryDataAreNoTexts) {
  tm date = {};
  date.tm_year = 120;
  EXPECT_NE(problemOf("map_frame", XmlRpcValue(&date)).find("must be a text, not the date"),
            std::string::npos);
  char data[] = "map";
  EXPECT_NE(problemOf("map_frame", XmlRpcValue(data, 3)).find("must be a text, not binary data"),
            std::string::npos);
  EXPECT_NE(problemOf("map_frame", XmlRpcValue()).find("must be a text, not nothing"),
            std::string::npos);
}

TEST(ToYaml, NumbersThatAreNotFiniteAreReported) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(parse(table("grid", "cell_size", nan)), config::ParameterError);
  EXPECT_THROW(parse(table("grid", "cell_size", inf)), config::ParameterError);
  EXPECT_THROW(parse(table("scan", "timeout", -inf)), config::ParameterError);
}

}  // namespace
}  // namespace place_memory::node
