#include "config/store_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "config/load_parameters.h"
#include "core/temporary_folder.h"

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

TEST(PathInStoreDirectory, LiesBelowIt) {
  const TemporaryFolder folder;
  const std::string root = std::filesystem::canonical(folder.path()).string();
  std::filesystem::create_directory(folder.file("floor"));
  EXPECT_EQ(pathInStoreDirectory(root, "a.db"), root + "/a.db");
  EXPECT_EQ(pathInStoreDirectory(root, "floor/../floor/a.db"), root + "/floor/a.db");
  EXPECT_EQ(pathInStoreDirectory(root, root + "/a.db"), root + "/a.db");
  EXPECT_EQ(pathInStoreDirectory(root, "..a"), root + "/..a");
  EXPECT_EQ(pathInStoreDirectory(root, "; rm -rf $HOME"), root + "/; rm -rf $HOME");
}

TEST(PathInStoreDirectory, NothingElseIsReached) {
  const TemporaryFolder folder;
  const TemporaryFolder other;
  const std::string root = folder.path().string();
  std::filesystem::create_directory_symlink(other.path(), folder.file("out"));
  std::filesystem::create_symlink(other.file("a.db"), folder.file("link.db"));
  std::filesystem::create_symlink("/nowhere/a.db", folder.file("dangling.db"));
  for (const std::string& name :
       {std::string(), std::string("  "), std::string("."), std::string(".."), std::string("a/"),
        std::string("../a.db"), std::string("floor/../../a.db"), std::string("/etc/passwd"),
        root + "2/a.db", std::string("~/a.db"), std::string("out/a.db"), std::string("link.db"),
        std::string("dangling.db"), std::string("a\n.db"), std::string("a\0.db", 5),
        std::string("places.db-journal"), std::string("places.db-wal"), std::string(2000, 'a')}) {
    EXPECT_THROW(pathInStoreDirectory(root, name), std::runtime_error) << name;
  }
  EXPECT_THROW(pathInStoreDirectory(root + "/none", "a.db"), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::config
