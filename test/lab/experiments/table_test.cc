#include "experiments/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace place_memory::experiments {
namespace {

Table sample() {
  Table table({"case", "accuracy"});
  table.add({"2 ft away, 1 chair", "0.8"});
  return table;
}

TEST(Table, MarkdownIsPadded) {
  std::ostringstream text;
  sample().writeMarkdown(text);
  EXPECT_EQ(text.str(),
            "| case               | accuracy |\n"
            "|--------------------|----------|\n"
            "| 2 ft away, 1 chair | 0.8      |\n");
}

TEST(Table, CsvQuotesCommas) {
  std::ostringstream text;
  sample().writeCsv(text);
  EXPECT_EQ(text.str(), "case,accuracy\n\"2 ft away, 1 chair\",0.8\n");
}

TEST(Fixed, HasItsDigitsAndIsEmptyForNoNumber) {
  EXPECT_EQ(fixed(0.125, 2), "0.12");
  EXPECT_EQ(fixed(2.0, 3), "2.000");
  EXPECT_EQ(fixed(std::nan(""), 3), "");
}

}  // namespace
}  // namespace place_memory::experiments
