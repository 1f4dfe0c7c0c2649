#include "support/text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::support {
namespace {

TEST(FirstNotUtf8, FindsTheFirstByteThatIsNoCharacter) {
  for (const char* text : {"", "plain",
                           "K\xc3\xbc"
                           "che",
                           "\xf0\x9f\x8d\xb3", "\xef\xbf\xbd"}) {
    EXPECT_FALSE(firstNotUtf8(text).has_value()) << text;
  }
  EXPECT_EQ(firstNotUtf8("K\xfc"
                         "che"),
            1U)
      << "Latin-1";
  EXPECT_EQ(firstNotUtf8("ab\xc3"), 2U) << "cut in a character";
  EXPECT_EQ(firstNotUtf8("\xc0\xaf"), 0U) << "overlong";
  EXPECT_EQ(firstNotUtf8("\xe0\x80\xaf"), 0U) << "overlong";
  EXPECT_EQ(firstNotUtf8("a\xed\xa0\x80"), 1U) << "surrogate";
  EXPECT_EQ(firstNotUtf8("\xf4\x90\x80\x80"), 0U) << "beyond the last character";
  EXPECT_EQ(firstNotUtf8("\x80"), 0U);
}

TEST(HasControls, KnowsThoseOfOneByteAndOfTwo) {
  EXPECT_FALSE(
      hasControls("K\xc3\xbc"
                  "che 5"));
  EXPECT_TRUE(hasControls("a\nb"));
  EXPECT_TRUE(hasControls(std::string("a\0b", 3)));
  EXPECT_TRUE(hasControls("\x7f"));
  EXPECT_TRUE(hasControls("\xc2\x85"));
}

TEST(Printable, ShowsBytesThatCannotBeShown) {
  EXPECT_EQ(printable("K\xc3\xbc"
                      "che"),
            "K\xc3\xbc"
            "che");
  EXPECT_EQ(printable("a\nb\xff"), "a\\x0ab\\xff");
}

TEST(DecodedText, LosesItsByteOrderMark) {
  EXPECT_EQ(decodedText("\xef\xbb\xbf"
                        "a"),
            "a");
  EXPECT_EQ(decodedText(""), "");
}

TEST(DecodedText, OtherEncodingsAreRefused) {
  EXPECT_THROW(decodedText(std::string("\xff\xfe"
                                       "a\0",
                                       4)),
               std::runtime_error);
  EXPECT_THROW(decodedText(std::string("\xfe\xff\0a", 4)), std::runtime_error);
  EXPECT_THROW(decodedText(std::string("a\0b\0", 4)), std::runtime_error);
  try {
    decodedText("a\nb\nK\xfc");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("line 3: is not UTF-8"), 0U) << error.what();
  }
}

TEST(Trimmed, TakesBlanksAndTabsFromBothEnds) {
  EXPECT_EQ(trimmed(" \ta b \t"), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
}

TEST(ParseDecimal, TakesDecimalNumbersAlone) {
  EXPECT_EQ(parseDecimal("12"), 12.0);
  EXPECT_EQ(parseDecimal("-.5"), -0.5);
  EXPECT_EQ(parseDecimal("1.0E+03"), 1000.0);
  EXPECT_EQ(parseDecimal("1e400"), INFINITY);
  EXPECT_EQ(parseDecimal("-1e400"), -INFINITY);
  for (const char* text :
       {"", ".", "-", "e5", "1e", "0x10", "nan", "inf", "1,5", " 1", "1 ", "1_0"}) {
    EXPECT_FALSE(parseDecimal(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace place_memory::support
