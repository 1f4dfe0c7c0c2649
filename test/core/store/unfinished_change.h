#ifndef PLACE_MEMORY_TEST_CORE_STORE_UNFINISHED_CHANGE_H
#define PLACE_MEMORY_TEST_CORE_STORE_UNFINISHED_CHANGE_H

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace place_memory::core {

/// Leaves what power leaves that fails while `sql` changes the store: some pages are written, and
/// the journal by which they are put back.
inline void leaveUnfinished(const std::string& path, const std::string& sql) {
  const pid_t child = fork();
  if (child == 0) {
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    sqlite3_exec(database, "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN IMMEDIATE",
                 nullptr, nullptr, nullptr);
    sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
    sqlite3_db_cacheflush(database);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_GT(std::filesystem::file_size(path + "-journal"), 512U);
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_UNFINISHED_CHANGE_H
