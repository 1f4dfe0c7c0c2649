#include "support/progress_bar.h"

#include <gtest/gtest.h>

#include <sstream>

namespace place_memory::support {
namespace {

std::string written(bool terminal) {
  std::ostringstream output;
  ProgressBar bar(2, "events", output, terminal);
  bar.show(0);
  bar.note("event 1: a word");
  bar.show(2);
  bar.finish();
  return output.str();
}

TEST(ProgressBar, IsDrawnOnATerminal) {
  const std::string text = written(true);
  EXPECT_NE(text.find("\r["), std::string::npos);
  EXPECT_NE(text.find("2/2 events"), std::string::npos);
}

TEST(ProgressBar, WritesNotesAloneElsewhere) { EXPECT_EQ(written(false), "event 1: a word\n"); }

TEST(ProgressBar, AFileIsNoTerminal) {
  const std::ostringstream file;
  EXPECT_FALSE(isTerminal(file));
}

}  // namespace
}  // namespace place_memory::support
