#include "node/input/echo_dialect.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace place_memory::node {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const core::SonarSpec kSpec{0.4, 0.1, 4.0};
const core::SonarSpec kFromZero{0.4, 0.0, 4.0};

/// Whether the last of the ranges is taken as no echo.
bool lastIsNoEcho(const std::vector<double>& ranges, const core::SonarSpec& spec = kSpec,
                  const config::NoEchoOptions& options = {}) {
  EchoDialect dialect;
  bool last = false;
  std::chrono::nanoseconds stamp{0};
  for (const double range : ranges) {
    last = dialect.noEcho(++stamp, range, spec, options).has_value();
  }
  return last;
}

config::NoEchoOptions strict() { return {false, false}; }

TEST(EchoDialect, TheVeryFirstMaxRangeIsNoEcho) {
  for (const double range :
       {4.0, 3.9999998, 4.0000002, 3.997, 4.003, 4.03, 3.4028234663852886e38}) {
    EXPECT_TRUE(lastIsNoEcho({range})) << range;
    EXPECT_FALSE(lastIsNoEcho({range}, kSpec, strict())) << range;
  }
  EXPECT_FALSE(lastIsNoEcho({3.99}));
  EXPECT_FALSE(lastIsNoEcho({4.05}));
}

TEST(EchoDialect, ZeroIsNoEchoWhereNothingIsTooClose) {
  EXPECT_TRUE(lastIsNoEcho({0.0}, kFromZero));
  EXPECT_FALSE(lastIsNoEcho({0.0}, kFromZero, strict()));
  EXPECT_FALSE(lastIsNoEcho({1.0, 0.0, 0.0, 0.0}, kSpec)) << "it may be covered";
}

TEST(EchoDialect, MinusOneIsNoEchoAtOnce) {
  for (const double word : {-1.0, -0.9999999}) {
    EXPECT_TRUE(lastIsNoEcho({word})) << word;
    EXPECT_TRUE(lastIsNoEcho({word}, kFromZero)) << word;
    EXPECT_FALSE(lastIsNoEcho({word, word, word, word}, kSpec, strict())) << word;
  }
}

TEST(EchoDialect, AnotherNegativeValueMustRepeat) {
  for (const double word : {-0.001, -2.0, -99.0}) {
    EXPECT_FALSE(lastIsNoEcho({word, word})) << word;
    EXPECT_TRUE(lastIsNoEcho({word, word, word})) << "whether or not echoes came: " << word;
    EXPECT_TRUE(lastIsNoEcho({word, 1.0, word, 1.2, word})) << word;
    EXPECT_FALSE(lastIsNoEcho({word, word, word}, kSpec, strict())) << word;
  }
  EXPECT_FALSE(lastIsNoEcho({-0.02, -0.03, -0.02, -0.04, -0.02})) << "an offset that is wrong";
}

TEST(EchoDialect, AValueBeyondMaxRangeMustRepeatWhileEchoesCome) {
  for (const double word : {4.1, 8.19, 65.535, 8190.0}) {
    EXPECT_FALSE(lastIsNoEcho({1.0, word, 1.2, word})) << word;
    EXPECT_TRUE(lastIsNoEcho({1.0, word, 1.2, word, 1.1, word})) << word;
    EXPECT_FALSE(lastIsNoEcho({word, word, word, word, word})) << "no echo ever came: " << word;
    EXPECT_FALSE(lastIsNoEcho({1.0, word, word, word, word}, kSpec, strict())) << word;
  }
  EXPECT_FALSE(lastIsNoEcho({1.0, 120.0, 121.0, 122.0, 120.0}));
}

TEST(EchoDialect, NamesAValueOutsideTheLimitsThatIsSaidAgainAndAgain) {
  for (const double word : {-1.0, 0.0, 8190.0, 65.535}) {
    EchoDialect dialect;
    std::chrono::nanoseconds stamp{0};
    for (int times = 0; times < 9; ++times) dialect.noEcho(++stamp, word, kSpec, strict());
    EXPECT_FALSE(dialect.repeatedOutside()) << word;
    dialect.noEcho(++stamp, 1.0, kSpec, strict());
    dialect.noEcho(++stamp, word, kSpec, strict());
    EXPECT_EQ(dialect.repeatedOutside(), word);
    dialect.noEcho(++stamp, 9.0, kSpec, strict());
    EXPECT_FALSE(dialect.repeatedOutside()) << word;
  }
}

TEST(EchoDialect, AValueThatComesBackAtTheTopIsNoEcho) {
  EXPECT_TRUE(lastIsNoEcho({3.57, 1.0, 3.57, 1.4, 3.57, 1.0, 3.57, 1.2, 3.57}));
  EXPECT_FALSE(lastIsNoEcho({3.57, 1.0, 3.57, 1.4, 3.57})) << "that may be chance";
  EXPECT_FALSE(lastIsNoEcho({3.57, 1.0, 3.57, 1.4, 3.57, 1.0, 3.57, 1.2, 3.57}, kSpec, strict()));
}

TEST(EchoDialect, AWallIsNoWordForNoEcho) {
  EXPECT_FALSE(lastIsNoEcho({3.57, 3.57, 3.57, 3.57, 3.57, 3.57})) << "the robot stands";
  EXPECT_FALSE(lastIsNoEcho({3.57, 3.56, 3.57, 3.56, 3.57, 3.56, 3.57, 3.56, 3.57, 3.56, 3.57}))
      << "noise of a centimetre";
  EXPECT_FALSE(lastIsNoEcho({2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 2.0}))
      << "far below max_range";
  EXPECT_FALSE(lastIsNoEcho({3.57, 1.0, 3.57, 1.4, 3.57, 1.0, 3.57, 1.0, 3.8, 3.57}))
      << "it hears farther";
}

TEST(EchoDialect, ReadingABagTwiceMakesNoWord) {
  EchoDialect dialect;
  for (int times = 0; times < 10; ++times) {
    EXPECT_FALSE(dialect.noEcho(std::chrono::seconds(1), 3.57, kSpec, {}));
    EXPECT_FALSE(dialect.noEcho(std::chrono::seconds(2), 1.0, kSpec, {}));
    EXPECT_FALSE(dialect.noEcho(std::chrono::seconds(3), -2.0, kSpec, {}));
  }
}

TEST(EchoDialect, WhatREP117SaysIsLeftAlone) {
  EXPECT_FALSE(lastIsNoEcho({kInf}));
  EXPECT_FALSE(lastIsNoEcho({-kInf}));
  EXPECT_FALSE(lastIsNoEcho({std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_FALSE(lastIsNoEcho({0.5}, {0.4, 0.5, 0.5})) << "a sensor of one distance";
}

}  // namespace
}  // namespace place_memory::node
