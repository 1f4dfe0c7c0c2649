#include "config/store_directory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "config/load_parameters.h"
#include "core/temporary_folder.h"

namespace place_memory::config {
namespace {

namespace fs = std::filesystem;

class StoreDirectory : public testing::Test {
 protected:
  StoreDirectory() { fs::create_directories(inside_); }

  std::string resolved(const std::string& path) const { return pathInside(inside_, path); }
  bool isRefused(const std::string& path) const {
    try {
      resolved(path);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what()).size() > 10;
    }
    return false;
  }

  const TemporaryFolder folder_;
  const std::string root_ = fs::canonical(folder_.path()).string();
  const std::string inside_ = root_ + "/maps";
};

TEST_F(StoreDirectory, FilesBelowItAreTaken) {
  EXPECT_EQ(resolved("a.db"), inside_ + "/a.db");
  EXPECT_EQ(resolved("./a.db"), inside_ + "/a.db");
  EXPECT_EQ(resolved("robots/a.db"), inside_ + "/robots/a.db");
  EXPECT_EQ(resolved(inside_ + "/a.db"), inside_ + "/a.db");
}

TEST_F(StoreDirectory, NothingElseIs) {
  for (const std::string& path :
       {std::string(), std::string(" "), std::string("../a.db"), std::string("robots/../../a.db"),
        std::string("/etc/passwd"), inside_ + "/../a.db", inside_, std::string("."),
        inside_ + "_too/a.db", std::string("a\nb.db"), std::string("~other/a.db"),
        std::string("~/a.db")}) {
    EXPECT_TRUE(isRefused(path)) << path;
  }
}

TEST_F(StoreDirectory, WhatNoPathCanBeIsNotRepeated) {
  try {
    resolved(std::string(1000000, 'x'));
    ADD_FAILURE() << "taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_LT(std::string(error.what()).size(), 200U) << error.what();
  }
}

TEST_F(StoreDirectory, LinksLeadNowhereElse) {
  fs::create_symlink(root_, inside_ + "/out");
  fs::create_symlink(root_ + "/not_there.db", inside_ + "/a.db");
  fs::create_symlink(inside_ + "/real.db", inside_ + "/link.db");
  writeFile(inside_ + "/real.db", "x");
  EXPECT_TRUE(isRefused("out/a.db"));
  EXPECT_TRUE(isRefused("out"));
  EXPECT_TRUE(isRefused("a.db"));
  EXPECT_EQ(resolved("link.db"), inside_ + "/real.db");
}

TEST_F(StoreDirectory, HasToBeThere) {
  EXPECT_THROW(pathInside("", "a.db"), std::invalid_argument);
  EXPECT_THROW(pathInside(root_ + "/none", "a.db"), std::invalid_argument);
}

TEST_F(StoreDirectory, IsTheFolderOfTheStoreUnlessAnotherOneIsGiven) {
  const auto of = [](const std::string& yaml) {
    return parseParameters(YAML::Load(yaml), "test").store_directory;
  };
  EXPECT_EQ(of("{}"), "");
  EXPECT_EQ(of("store: /data/places.db"), "/data");
  EXPECT_EQ(of("{store: /data/places.db, store_directory: /maps}"), "/maps");
}

}  // namespace
}  // namespace place_memory::config
