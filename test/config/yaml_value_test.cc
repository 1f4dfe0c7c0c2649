#include "config/yaml_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace place_memory::config {
namespace {

/// A value as it stands in a file, and the number that roslaunch puts on the parameter server.
struct Number {
  const char* text;
  double value;
};

void PrintTo(const Number& number, std::ostream* out) { *out << number.text; }

class YamlNumber : public testing::TestWithParam<Number> {};

TEST_P(YamlNumber, IsWhatRoslaunchMakesOfIt) {
  const YAML::Node node = YAML::Load(GetParam().text);
  EXPECT_EQ(kindOf(node), ValueKind::kNumber);
  ASSERT_TRUE(numberOf(node).has_value());
  EXPECT_DOUBLE_EQ(*numberOf(node), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    YamlValue, YamlNumber,
    testing::Values(Number{"5", 5.0}, Number{"-5", -5.0}, Number{"+5", 5.0}, Number{"0", 0.0},
                    Number{"1_000", 1000.0}, Number{"010", 8.0}, Number{"0x1F", 31.0},
                    Number{"-0x10", -16.0}, Number{"0b101", 5.0}, Number{"1:30", 90.0},
                    Number{"-1:30:00", -5400.0}, Number{"0.25", 0.25}, Number{"010.5", 10.5},
                    Number{".5", 0.5}, Number{"5.", 5.0}, Number{"1.5e+3", 1500.0},
                    Number{"1.5E-3", 0.0015}, Number{"1:30.5", 90.5}, Number{"1_0.2_5", 10.25},
                    Number{"deg(2)", M_PI / 90.0}, Number{"deg( -90 )", -M_PI / 2.0},
                    Number{"deg(1e1)", M_PI / 18.0}, Number{"rad(pi/90)", M_PI / 90.0},
                    Number{"rad(2*pi - 1)", 2.0 * M_PI - 1.0}, Number{"rad(0.5)", 0.5},
                    Number{"rad(-pi**2/4)", -M_PI* M_PI / 4.0}, Number{"!degrees 180", M_PI},
                    Number{"!radians 2*pi", 2.0 * M_PI}, Number{"!degrees deg(180)", M_PI},
                    Number{"!!float 1", 1.0}, Number{"!!int \"5\"", 5.0}));

class TextMeantAsNumber : public testing::TestWithParam<Number> {};

TEST_P(TextMeantAsNumber, IsATextThatServesAsNumber) {
  for (const std::string quote : {"", "\""}) {
    const YAML::Node node = YAML::Load(quote + GetParam().text + quote);
    EXPECT_EQ(kindOf(node), ValueKind::kText) << quote;
    ASSERT_TRUE(numberOf(node).has_value()) << quote;
    EXPECT_DOUBLE_EQ(*numberOf(node), GetParam().value) << quote;
  }
}

INSTANTIATE_TEST_SUITE_P(YamlValue, TextMeantAsNumber,
                         testing::Values(Number{"1e-2", 0.01}, Number{"1E2", 100.0},
                                         Number{"1.5e3", 1500.0}, Number{"-.5", -0.5},
                                         Number{"pi", M_PI}, Number{"pi/2", M_PI / 2.0},
                                         Number{"2 * (pi - 1)", 2.0 * (M_PI - 1.0)}));

TEST(YamlValue, QuotedAnglesAreNumbersToo) {
  EXPECT_DOUBLE_EQ(*numberOf(YAML::Load("'deg(2)'")), M_PI / 90.0) << "as <param value=...> has it";
  EXPECT_EQ(kindOf(YAML::Load("'deg(2)'")), ValueKind::kText);
}

TEST(YamlValue, InfinityAndNanAreNumbers) {
  EXPECT_EQ(*numberOf(YAML::Load(".inf")), INFINITY);
  EXPECT_EQ(*numberOf(YAML::Load("-.INF")), -INFINITY);
  EXPECT_TRUE(std::isnan(*numberOf(YAML::Load(".nan"))));
  EXPECT_EQ(*numberOf(YAML::Load("1e999")), INFINITY);
}

TEST(YamlValue, OtherTextsAreNoNumbers) {
  for (const char* text :
       {"nan",     "inf",    "08",        "1.2.3",       "0,5",   "12 m", "two",     "'5'", "'0.1'",
        "!!str 5", "deg(x)", "deg(45/2)", "rad(import)", "rad()", "pie",  "spin",    "2pi", "pi/",
        "((((pi",  "1e",     "e5",        "2020-01-31",  "true",  "~",    "rad(1**)"}) {
    EXPECT_FALSE(numberOf(YAML::Load(text)).has_value()) << text;
  }
}

TEST(YamlValue, FlagsAreThoseOfYaml11) {
  for (const char* text : {"true", "True", "TRUE", "yes", "Yes", "on", "ON"}) {
    EXPECT_EQ(flagOf(YAML::Load(text)), true) << text;
  }
  for (const char* text : {"false", "No", "off"}) {
    EXPECT_EQ(flagOf(YAML::Load(text)), false) << text;
  }
  for (const char* text : {"y", "n", "yEs", "'yes'", "1"}) {
    EXPECT_FALSE(flagOf(YAML::Load(text)).has_value()) << text;
  }
}

TEST(YamlValue, OtherKinds) {
  EXPECT_EQ(kindOf(YAML::Load("y")), ValueKind::kText);
  EXPECT_EQ(kindOf(YAML::Load("'~'")), ValueKind::kText);
  EXPECT_EQ(kindOf(YAML::Load("|\n  5\n")), ValueKind::kText);
  EXPECT_EQ(kindOf(YAML::Load("~")), ValueKind::kNothing);
  EXPECT_EQ(kindOf(YAML::Load("2020-01-31")), ValueKind::kDate);
  EXPECT_EQ(kindOf(YAML::Load("2020-01-31 10:00:00 Z")), ValueKind::kDate);
  EXPECT_EQ(kindOf(YAML::Load("!!binary aGk=")), ValueKind::kBinary);
  EXPECT_EQ(kindOf(YAML::Load("!metres 5")), ValueKind::kForeign);
  EXPECT_EQ(kindOf(YAML::Load(std::string(100000, '1'))), ValueKind::kText) << "too long";
}

TEST(YamlValue, IsShownWithoutControlCharacters) {
  EXPECT_EQ(shown(YAML::Load("\"a\\nb\\0c\"")), "'a\\x0ab\\x00c'");
  EXPECT_EQ(shown(YAML::Load("2020-01-31")), "the date '2020-01-31'");
}

}  // namespace
}  // namespace place_memory::config
