#include "tools/command_line.h"

#include <gtest/gtest.h>

#include <sstream>

namespace place_memory::tools {
namespace {

std::optional<Arguments> read(std::vector<const char*> words, std::string* help = nullptr) {
  words.insert(words.begin(), "place_memory_bag");
  std::ostringstream written;
  const auto arguments = readArguments(static_cast<int>(words.size()), words.data(), written);
  if (help != nullptr) *help = written.str();
  return arguments;
}

const std::vector<const char*> kNeeded = {"--bag", "a.bag", "--events", "e.csv", "--out", "r.csv"};

std::vector<const char*> neededAnd(std::initializer_list<const char*> more) {
  std::vector<const char*> words = kNeeded;
  words.insert(words.end(), more);
  return words;
}

TEST(ReadArguments, TakesEachOption) {
  const auto arguments =
      read(neededAnd({"--params", "1.yaml", "--params", "2.yaml", "--store", "/data/places.db"}));
  ASSERT_TRUE(arguments.has_value());
  EXPECT_EQ(arguments->bags, (std::vector<std::string>{"a.bag"}));
  EXPECT_EQ(arguments->events, "e.csv");
  EXPECT_EQ(arguments->out, "r.csv");
  EXPECT_EQ(arguments->params, (std::vector<std::string>{"1.yaml", "2.yaml"}));
  EXPECT_EQ(arguments->store, "/data/places.db");
  EXPECT_EQ(read(kNeeded)->store, "");
  EXPECT_EQ(read({"--bag", "a.bag", "--out", "r.csv"})->events, "");
}

TEST(ReadArguments, TakesSeveralBags) {
  const std::vector<std::string> bags = {"a.bag", "b.bag", "c.bag"};
  EXPECT_EQ(read({"--bag", "a.bag", "--out", "r.csv", "--bag", "b.bag", "c.bag"})->bags, bags);
  EXPECT_EQ(read({"--bag", "a.bag", "b.bag", "c.bag", "--out", "r.csv"})->bags, bags);
}

TEST(ReadArguments, TakesAReport) {
  EXPECT_EQ(read(neededAnd({"--report", "r.html"}))->report, "r.html");
  EXPECT_EQ(read(kNeeded)->report, "");
}

TEST(ReadArguments, WritesHelpAndNothingElse) {
  std::string help;
  EXPECT_FALSE(read({"--help"}, &help).has_value());
  for (const char* word :
       {"usage:", "--events", "--report", "Exit status", "force", "header stamps"}) {
    EXPECT_NE(help.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(help.find("stray"), std::string::npos);
}

std::string problem(const std::vector<const char*>& words) {
  try {
    read(words);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

TEST(ReadArguments, NamesWhatIsWrong) {
  EXPECT_NE(problem(neededAnd({"more.yaml"})).find("'more.yaml'"), std::string::npos);
  EXPECT_NE(problem(neededAnd({"--", "--more"})).find("'--more'"), std::string::npos);
  EXPECT_NE(problem(neededAnd({"--verbose"})).find("--verbose"), std::string::npos);
  EXPECT_NE(problem({"--bag", "a.bag"}).find("--out"), std::string::npos);
  EXPECT_NE(problem(neededAnd({"--store", "~nobody/p.db"})).find("--store"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::tools
