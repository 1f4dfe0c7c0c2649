#include "support/csv.h"

#include <gtest/gtest.h>

#include <sstream>

namespace place_memory::support {
namespace {

using Fields = std::vector<std::string>;

std::vector<Fields> read(const std::string& text) {
  std::istringstream input(text);
  std::vector<Fields> records;
  int line = 0;
  while (const auto fields = readRecord(input, line)) records.push_back(*fields);
  return records;
}

TEST(ReadRecord, LinesEndAsOnAnySystem) {
  const std::vector<Fields> expected{{"a", "b"}, {""}, {"c"}};
  EXPECT_EQ(read("a,b\n\nc\n"), expected);
  EXPECT_EQ(read("a,b\r\n\r\nc\r\n"), expected);
  EXPECT_EQ(read("a,b\r\rc\r"), expected);
  EXPECT_EQ(read("a,b\n\nc"), expected);
}

TEST(ReadRecord, BlanksCountOnlyInQuotes) {
  EXPECT_EQ(read(" a ,\tb c\t, , \" d \" \n"), (std::vector<Fields>{{"a", "b c", "", " d "}}));
}

TEST(ReadRecord, LeavesOutComments) {
  EXPECT_EQ(read("# a \"quote\n#\r\na,#b\n# end"), (std::vector<Fields>{{"a", "#b"}}));
}

TEST(ReadRecord, CountsLinesOfEachKind) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::istringstream input("# first" + end + "a,\"b" + end + "c\"" + end + "d");
    int line = 0;
    readRecord(input, line);
    EXPECT_EQ(line, 3);
    readRecord(input, line);
    EXPECT_EQ(line, 4);
  }
}

TEST(ReadRecord, AnOpenQuoteIsRefused) { EXPECT_THROW(read("a,\"b\n"), std::runtime_error); }

TEST(CsvField, ComesBackAsItWas) {
  for (const std::string text : {"", "plain", "a,b", "\"", "two\nlines", "caf\xc3\xa9", " a ", "#a",
                                 "a\rb", "\"\"", " \"a"}) {
    EXPECT_EQ(read(csvField(text) + ",end\n"), (std::vector<Fields>{{text, "end"}})) << text;
  }
}

}  // namespace
}  // namespace place_memory::support
