#ifndef PLACE_MEMORY_TEST_CORE_STORE_READ_ONLY_H
#define PLACE_MEMORY_TEST_CORE_STORE_READ_ONLY_H

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

namespace place_memory::core {

/// While it lives files are reached as by a user who owns none of them; root may write everything.
class AsNobody {
 public:
  AsNobody() { EXPECT_EQ(seteuid(65534), 0); }
  ~AsNobody() { EXPECT_EQ(seteuid(0), 0); }
};

/// While it lives the file, and where it lies, may be read and not written.
class ReadOnly {
 public:
  explicit ReadOnly(const std::filesystem::path& file) : file_(file) {
    std::filesystem::permissions(file_, std::filesystem::perms(0444));
    std::filesystem::permissions(file_.parent_path(), std::filesystem::perms(0555));
    if (geteuid() == 0) nobody_.emplace();
  }
  ~ReadOnly() {
    nobody_.reset();
    std::filesystem::permissions(file_.parent_path(), std::filesystem::perms(0777));
    std::filesystem::permissions(file_, std::filesystem::perms(0666));
  }
  ReadOnly(const ReadOnly&) = delete;
  ReadOnly& operator=(const ReadOnly&) = delete;

 private:
  const std::filesystem::path file_;
  std::optional<AsNobody> nobody_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_READ_ONLY_H
