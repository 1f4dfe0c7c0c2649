#include "tools/event_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <sstream>
#include <utility>

namespace place_memory::tools {
namespace {

const std::string kHeader = "start,end,action,label,heading_window\n";

const ros::Time kBagStart(1000, 250000000);

std::vector<Event> parse(const std::string& text) {
  std::istringstream table(text);
  return readEvents(table, "events.csv", 0.5, kBagStart);
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

/// A table as some program saves it, of one event: learn Kueche from 1000 s to 1005.5 s.
struct Dialect {
  const char* what;
  std::string text;
};

void PrintTo(const Dialect& dialect, std::ostream* out) { *out << dialect.what; }

const std::string kKitchen =
    "K\xc3\xbc"
    "che";

class EventDialect : public testing::TestWithParam<Dialect> {};

TEST_P(EventDialect, IsRead) {
  const auto events = parse(GetParam().text);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].start, ros::Time(1000.0));
  EXPECT_EQ(events[0].end, ros::Time(1005.5));
  EXPECT_EQ(events[0].action, Action::kLearn);
  EXPECT_EQ(events[0].label, kKitchen);
  EXPECT_EQ(events[0].heading_window, 0.5);
  EXPECT_FALSE(events[0].force);
}

const std::string kRow = "1000.0,1005.5,learn," + kKitchen;
INSTANTIATE_TEST_SUITE_P(
    ReadEvents, EventDialect,
    testing::Values(Dialect{"plain", kHeader + kRow + ",\n"},
                    Dialect{"byte order mark", "\xef\xbb\xbf" + kHeader + kRow + ",\n"},
                    Dialect{"CRLF", "start,end,action,label,heading_window\r\n" + kRow + ",\r\n"},
                    Dialect{"CR", "start,end,action,label,heading_window\r" + kRow + ",\r"},
                    Dialect{"blanks", kHeader + "1000.0, 1005.5, learn, " + kKitchen + ", \n"},
                    Dialect{"blanks in the header",
                            "start, end, action, label, heading_window\n" + kRow + ",\n"},
                    Dialect{"blanks before a quote",
                            kHeader + "1000.0, 1005.5, learn, \"" + kKitchen + "\",\n"},
                    Dialect{"short row", kHeader + kRow + "\n"},
                    Dialect{"long row", kHeader + kRow + ",,,,\n"},
                    Dialect{"exponents", kHeader + "1.0E+03,1.0055E+03,learn," + kKitchen + ",\n"},
                    Dialect{"rows of commas", kHeader + ",,,,\n" + kRow + ",\n,,,,\n , ,\n"},
                    Dialect{"comments",
                            "# mine\n" + kHeader + "# it's \"one\n" + kRow + ",\n# end"},
                    Dialect{"no last line end", kHeader + kRow + ","},
                    Dialect{"column force",
                            "start,end,action,label,heading_window,force\n" + kRow + ",,false\n"},
                    Dialect{"column force in short rows",
                            "start,end,action,label,heading_window,force\n" + kRow + "\n"}));

TEST(ReadEvents, LabelsMayHoldAnyCharacter) {
  EXPECT_EQ(parse(kHeader + "1,2,learn," + kKitchen + " \xf0\x9f\x8d\xb3,\n").at(0).label,
            kKitchen + " \xf0\x9f\x8d\xb3");
}

TEST(ReadEvents, AShortRowHasNoLabel) {
  const auto events = parse(kHeader + "1,2,recognize\n");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].label, "");
  EXPECT_EQ(events[0].heading_window, 0.5);
}

TEST(ReadEvents, RelativeTimesCountFromTheStartOfTheBag) {
  const auto events = parse(kHeader + "+0,+12.5,learn,a,\n1004,+20,recognize,,\n");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].start, kBagStart);
  EXPECT_EQ(events[0].end, ros::Time(1012, 750000000));
  EXPECT_EQ(events[1].start, ros::Time(1004.0));
  EXPECT_EQ(events[1].end, ros::Time(1020, 250000000));
}

TEST(ReadEvents, ForceIsReadWhereTheColumnIsThere) {
  const std::string header = "start,end,action,label,heading_window,force\n";
  const std::pair<const char*, bool> words[] = {{"true", true}, {"yes", true}, {"1", true},
                                                {"no", false},  {"0", false},  {"", false}};
  for (const auto& [word, force] : words) {
    EXPECT_EQ(parse(header + "1,2,learn,a,0.5," + word + "\n").at(0).force, force) << word;
  }
}

struct Malformed {
  const char* what;
  std::string text;
  const char* error;  // part of it
};

void PrintTo(const Malformed& m, std::ostream* out) { *out << m.what; }

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
        Malformed{"binary", std::string("\1\2\3\n", 4), "line 1: must be the header"},
        Malformed{
            "semicolons", "start;end;action;label;heading_window\n1000,0;1005,5;learn;a;\n",
            "line 1: must be the header start,end,action,label,heading_window, with ,force or "
            "not; this table is divided by semicolons"},
        Malformed{"tabs", "start\tend\taction\tlabel\theading_window\n", "is divided by tabs"},
        Malformed{"latin-1",
                  kGood + "3,4,learn,K\xfc"
                          "che,\n",
                  "line 3: is not UTF-8"},
        Malformed{"too few fields", kGood + "1,2\n", "line 3: has 2 fields, and no action"},
        Malformed{"one field", kGood + "# 2\nx\n", "line 4: has 1 fields, and no end"},
        Malformed{"empty action", kGood + "1,2,,a\n", "line 3: action must be learn or recognize"},
        Malformed{"past 2^31 s", kHeader + "0,2147483647,learn,whole,\n",
                  "line 2: end must be at most a day after start"},
        Malformed{"last second", kHeader + "0,4294967295,learn,whole,\n",
                  "line 2: end must be a number of seconds from 0 to 4294960000"},
        Malformed{"past 2^32 s", kHeader + "99999999999,99999999999,learn,a,\n",
                  "line 2: start must be a number of seconds"},
        Malformed{"past every number", kHeader + "1e999,2,learn,a,\n", "line 2: start must be"},
        Malformed{"relative past 2^32 s", kHeader + "+0,+4294960000,learn,a,\n",
                  "line 2: end must be a number of seconds"},
        Malformed{"relative and negative", kHeader + "+-1,+2,learn,a,\n", "line 2: start must be"},
        Malformed{"decimal comma", kHeader + "\"1000,0\",1005,learn,a,\n",
                  "line 2: start must be a number of seconds from 0 to 4294960000, or +seconds "
                  "since the first header stamp, not '1000,0'"},
        Malformed{"unknown force",
                  "start,end,action,label,heading_window,force\n1,2,learn,a,,maybe\n",
                  "line 2: force must be true or false, not 'maybe'"},
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

TEST(ReadEvents, Utf16IsNamed) {
  // As spreadsheets save "Unicode text".
  std::string text = "\xff\xfe";
  for (const char c : kGood) text += {c, '\0'};
  try {
    parse(text);
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("events.csv, is UTF-16"), 0U) << error.what();
  }
}

}  // namespace
}  // namespace place_memory::tools
