#include "core/map/place_label.h"

#include <gtest/gtest.h>

#include <string>

namespace place_memory::core {
namespace {

TEST(PlaceLabel, TakesText) {
  EXPECT_TRUE(isValidLabel("a"));
  EXPECT_TRUE(isValidLabel("by the window, 2nd floor"));
  EXPECT_TRUE(
      isValidLabel("K\xc3\xbc"
                   "che"));
  EXPECT_TRUE(isValidLabel("\xf0\x9f\x9a\xaa"));
  EXPECT_TRUE(isValidLabel(std::string(kMaxLabelBytes, 'x')));
}

TEST(PlaceLabel, RefusesWhatIsNoText) {
  EXPECT_FALSE(isValidLabel("")) << "empty";
  EXPECT_FALSE(isValidLabel("  ")) << "blank";
  EXPECT_FALSE(isValidLabel(std::string(kMaxLabelBytes + 1, 'x'))) << "too long";
  EXPECT_FALSE(isValidLabel("a\nb")) << "line break";
  EXPECT_FALSE(isValidLabel(std::string("a\0b", 3))) << "null";
  EXPECT_FALSE(isValidLabel("\x7f")) << "delete";
  EXPECT_FALSE(isValidLabel("\xc2\x85")) << "control character of two bytes";
  EXPECT_FALSE(isValidLabel("\xff")) << "no UTF-8";
  EXPECT_FALSE(isValidLabel("\xc3")) << "cut in a character";
  EXPECT_FALSE(isValidLabel("\xc0\xaf")) << "overlong";
  EXPECT_FALSE(isValidLabel("\xed\xa0\x80")) << "surrogate";
}

}  // namespace
}  // namespace place_memory::core
