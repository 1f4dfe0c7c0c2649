#include "tools/record_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace place_memory::tools {
namespace {

RecordTable example() {
  RecordTable table({"label", "id", "x", "known"});
  table.add({std::string("k\u00fcche"), std::int64_t{7}, Decimal{-1.5, 2}, true});
  table.add({std::string("a \"b\"\n"), std::int64_t{12},
             Decimal{std::numeric_limits<double>::quiet_NaN(), 2}, false});
  return table;
}

TEST(RecordTable, StandsInColumns) {
  std::ostringstream text;
  example().print(text);
  EXPECT_EQ(text.str(),
            "label      id      x  known\n"
            "k\u00fcche       7  -1.50  yes\n"
            "a \"b\"\\x0a  12      -  no\n");
}

TEST(RecordTable, IsJson) {
  std::ostringstream text;
  example().printJson(text);
  EXPECT_EQ(text.str(),
            "[\n"
            "  {\"label\": \"k\u00fcche\", \"id\": 7, \"x\": -1.50, \"known\": true},\n"
            "  {\"label\": \"a \\\"b\\\"\\\\x0a\", \"id\": 12, \"x\": null, \"known\": false}\n"
            "]\n");
}

TEST(RecordTable, WithoutARecordIsNothingForPeopleAndAnEmptyArrayForPrograms) {
  std::ostringstream text;
  const RecordTable table({"label"});
  table.print(text);
  EXPECT_EQ(text.str(), "");
  table.printJson(text);
  EXPECT_EQ(text.str(), "[]\n");
}

}  // namespace
}  // namespace place_memory::tools
