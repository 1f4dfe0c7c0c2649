#ifndef PLACE_MEMORY_TEST_CORE_STORE_FULL_DISK_H
#define PLACE_MEMORY_TEST_CORE_STORE_FULL_DISK_H

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

namespace place_memory::core {

/// While it lives no file grows, as with a full disk.
class FullDisk {
 public:
  FullDisk() {
    signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit none{0, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  }
  ~FullDisk() {
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0);
    signal(SIGXFSZ, SIG_DFL);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_FULL_DISK_H
