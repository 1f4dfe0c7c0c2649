#include "config/store_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "config/load_parameters.h"

namespace place_memory::config {
namespace {

class StorePath : public testing::Test {
 protected:
  void SetUp() override {
    const char* home = std::getenv("HOME");
    had_home_ = home != nullptr;
    if (had_home_) home_ = home;
    setenv("HOME", "/home/of/robot", 1);
  }
  void TearDown() override {
    if (had_home_) {
      setenv("HOME", home_.c_str(), 1);
    } else {
      unsetenv("HOME");
    }
  }

 private:
  bool had_home_ = false;
  std::string home_;
};

std::string storeOf(const std::string& yaml) {
  return parseParameters(YAML::Load(yaml), "test").store;
}

std::string problemOf(const std::string& yaml) {
  try {
    storeOf(yaml);
  } catch (const ParameterError& error) {
    return error.problems().front();
  }
  return "none";
}

TEST_F(StorePath, IsSaidFromTheRoot) {
  EXPECT_EQ(storeOf("store: /data/places.db"), "/data/places.db");
  EXPECT_EQ(storeOf("store: ~/places.db"), "/home/of/robot/places.db");
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(storeOf("store: places.db"), here + "/places.db");
  EXPECT_EQ(storeOf("store: ./a/../places.db"), here + "/places.db");
  EXPECT_EQ(storeOf("store: ''"), "") << "in memory only";
}

TEST_F(StorePath, WhatIsNoFileIsRefused) {
  EXPECT_NE(problemOf("store: ~").find("must be a text, not nothing"), std::string::npos);
  EXPECT_NE(problemOf("store: '~'").find("is a folder"), std::string::npos);
  EXPECT_NE(problemOf("store: ~/").find("is a folder"), std::string::npos);
  EXPECT_NE(problemOf("store: ~other/places.db").find("another user"), std::string::npos);
  EXPECT_NE(problemOf("store: \"a\\nb\"").find("control characters"), std::string::npos);
  EXPECT_NE(problemOf("store: \"a\\0b\"").find("control characters"), std::string::npos);
  EXPECT_NE(problemOf("store: '  '").find("blank"), std::string::npos);
  unsetenv("HOME");
  EXPECT_NE(problemOf("store: ~/places.db").find("HOME is not set"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::config
