#include "tools/event_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <sstream>

#include "support/csv.h"

namespace place_memory::tools {
namespace {

const std::string kHeader = "start,end,action,label,heading_window\n";

std::vector<Event> parse(const std::string& text) {
  std::istringstream table(text);
  return readEvents(table, "events.csv", 0.5);
}

TEST(ReadEvents, ReadsEveryColumn) {
  const auto events = parse(kHeader + "10.5,12,learn,Room 1,0.7854\r\n20,21,recognize,,3.1416\n");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].start, ros::Time(10.5));
  EXPECT_EQ(events[0].end, ros::Time(12.0));
  EXPECT_EQ(events[0].action, Action::kLearn);
  EXPECT_EQ(events[0].label, "Room 1");
  EXPECT_EQ(events[0].heading_window, 0.7854);
  EXPECT_EQ(events[1].action, Action::kRecognize);
  EXPECT_EQ(events[1].label, "");
  EXPECT_LE(events[1].heading_window, M_PI) << "pi with few digits is pi";
}

TEST(ReadEvents, AWindowThatIsLeftOpenIsTheParameters) {
  EXPECT_EQ(parse(kHeader + "1,2,recognize,,\n").at(0).heading_window, 0.5);
}

TEST(ReadEvents, LabelsMayHoldCommasQuotesAndLines) {
  const auto events = parse(kHeader + "1,2,learn,\"a, \"\"b\"\"\nc\",0.1\n3,4,learn,d,0.1");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].label, "a, \"b\"\nc");
  EXPECT_EQ(events[1].label, "d");
}

TEST(ReadEvents, AHeaderAloneIsNoEvents) { EXPECT_TRUE(parse(kHeader).empty()); }

TEST(CsvField, ComesBackAsItWas) {
  for (const std::string text : {"", "plain", "a,b", "\"", "two\nlines", "caf\xc3\xa9"}) {
    std::istringstream line(support::csvField(text) + ",end\n");
    int count = 0;
    EXPECT_EQ(support::readRecord(line, count), (std::vector<std::string>{text, "end"}));
  }
}

struct Malformed {
  const char* what;
  std::string text;
  const char* error;  // part of it
};

std::ostream& operator<<(std::ostream& out, const Malformed& m) { return out << m.what; }

class MalformedEvents : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedEvents, AreRefusedWithFileAndLine) {
  try {
    parse(GetParam().text);
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().error), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("events.csv, line "), 0U) << error.what();
  }
}

const std::string kGood = kHeader + "1,2,learn,a,0.5\n";
INSTANTIATE_TEST_SUITE_P(
    ReadEvents, MalformedEvents,
    testing::Values(
        Malformed{"empty", "", "line 1: must be the header"},
        Malformed{"no header", "1,2,learn,a,0.5\n", "line 1: must be the header"},
        Malformed{"other header", "start,end\n", "line 1: must be the header"},
        Malformed{"binary", std::string("\0\1\2\n", 4), "line 1: must be the header"},
        Malformed{"too few fields", kGood + "1,2,learn,a\n", "line 3: has 4 fields, not 5"},
        Malformed{"too many fields", kGood + "1,2,learn,a,0.5,x\n", "line 3: has 6 fields, not 5"},
        Malformed{"start is no number", kGood + "x,2,learn,a,0.5\n", "line 3: start must be"},
        Malformed{"start is NaN", kGood + "nan,2,learn,a,0.5\n", "line 3: start must be"},
        Malformed{"start is negative", kGood + "-1,2,learn,a,0.5\n", "line 3: start must be"},
        Malformed{"end is infinite", kGood + "1,inf,learn,a,0.5\n", "line 3: end must be"},
        Malformed{"end is empty", kGood + "1,,learn,a,0.5\n", "line 3: end must be"},
        Malformed{"end is start", kGood + "2,2,learn,a,0.5\n", "line 3: end must be after start"},
        Malformed{"unknown action", kGood + "1,2,forget,a,0.5\n", "line 3: action must be"},
        Malformed{"window is too wide", kGood + "1,2,learn,a,3.2\n", "heading_window must be"},
        Malformed{"window is negative", kGood + "1,2,learn,a,-0.1\n", "heading_window must be"},
        Malformed{"window is no number", kGood + "1,2,learn,a,wide\n", "heading_window must be"},
        Malformed{"open quote", kGood + "1,2,learn,\"a,0.5\n", "a quote is not closed"}));

}  // namespace
}  // namespace place_memory::tools
