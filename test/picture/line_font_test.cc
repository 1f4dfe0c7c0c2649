#include "picture/line_font.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace place_memory::picture {
namespace {

TEST(LineFont, LettersStandOneAfterTheOther) {
  const auto one = strokes("l");
  const auto two = strokes("ll");
  ASSERT_EQ(two.size(), 2 * one.size());
  EXPECT_NEAR(two[one.size()][0].x - one[0][0].x, kAdvance, 1e-12);
  EXPECT_NEAR(two[one.size()][0].y, one[0][0].y, 1e-12);
}

TEST(LineFont, EveryLetterStaysInItsRoom) {
  for (char letter = ' '; letter <= '~'; ++letter) {
    for (const auto& stroke : strokes(std::string(1, letter))) {
      ASSERT_FALSE(stroke.empty()) << letter;
      for (const Point& point : stroke) {
        EXPECT_GE(point.x, 0.0) << letter;
        EXPECT_LT(point.x, kAdvance) << letter;
        EXPECT_GE(point.y, -0.3) << letter;
        EXPECT_LE(point.y, 0.71) << letter;
      }
    }
  }
}

TEST(LineFont, LettersAndDigitsAreAllDifferent) {
  const std::string letters = "123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-.";
  const auto drawn = [](char letter) {
    std::vector<double> numbers;
    for (const auto& stroke : strokes(std::string(1, letter))) {
      numbers.push_back(-1.0);
      for (const Point& point : stroke) numbers.insert(numbers.end(), {point.x, point.y});
    }
    return numbers;
  };
  for (const char one : letters) {
    for (const char other : letters) {
      if (one == other) continue;
      EXPECT_NE(drawn(one), drawn(other)) << one << other;
    }
  }
}

TEST(LineFont, WhatItDoesNotHaveIsABoxEach) {
  EXPECT_EQ(countLetters("K\xc3\xbc"
                         "che"),
            5U);
  EXPECT_NEAR(widthOf("K\xc3\xbc"
                      "che",
                      2.0),
              10.0 * kAdvance, 1e-12);
  const auto box = strokes("\xc3\xbc");
  ASSERT_EQ(box.size(), 1U);
  EXPECT_EQ(box[0].size(), 5U);
}

}  // namespace
}  // namespace place_memory::picture
