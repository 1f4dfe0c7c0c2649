#include "endurance/power_cut.h"

#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <string>

namespace place_memory {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSector = 512;

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What the disk is sure to hold of a file, and what it may hold.
struct DiskFile {
  std::string synchronized;
  std::set<std::size_t> written;  ///< sectors, since then
  bool resized = false;           ///< since then
  bool is_name_sure = true;
};

/// The disk behind all files. Its power fails once.
class Disk {
 public:
  void failAt(int operation, unsigned seed) {
    operations_left_ = operation;
    random_.seed(seed);
  }

  /// Before anything is done to it.
  void operate() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--operations_left_ == 0) fail();
  }

  void opened(const std::string& path, bool was_there) {
    const std::lock_guard<std::mutex> lock(mutex_);
    deleted_.erase(path);
    const auto [at, is_new] = files_.try_emplace(path);
    if (!is_new && was_there) return;
    at->second = DiskFile();
    if (was_there) at->second.synchronized = contentOf(path);
    at->second.is_name_sure = was_there;
  }

  void wrote(const std::string& path, std::size_t offset, std::size_t size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    DiskFile& file = files_.at(path);
    for (std::size_t sector = offset / kSector; sector * kSector < offset + size; ++sector) {
      file.written.insert(sector);
    }
    file.resized = file.resized || offset + size > file.synchronized.size();
  }

  void truncated(const std::string& path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    files_.at(path).resized = true;
  }

  /// SQLite synchronizes the name of a new file with it.
  void synchronized(const std::string& path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    DiskFile& file = files_.at(path);
    if (!file.written.empty() || file.resized) file.synchronized = contentOf(path);
    file.written.clear();
    file.resized = false;
    file.is_name_sure = true;
  }

  void deletes(const std::string& path, bool for_sure) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto file = files_.find(path);
    const std::string content =
        file == files_.end() ? contentOf(path) : std::move(file->second.synchronized);
    if (file != files_.end()) files_.erase(file);
    if (!for_sure) deleted_[path] = content;
  }

 private:
  bool chance() { return (random_() & 1U) != 0; }

  [[noreturn]] void fail() {
    for (const auto& [path, file] : files_) loseSome(path, file);
    for (const auto& [path, content] : deleted_) {
      if (chance() && !fs::exists(path)) std::ofstream(path, std::ios::binary) << content;
    }
    _exit(kPowerFailed);
  }

  void loseSome(const std::string& path, const DiskFile& file) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return;
    if (!file.is_name_sure && chance()) {
      fs::remove(path, ignored);
      return;
    }
    if (file.written.empty() && !file.resized) return;
    std::string content = contentOf(path);
    if (file.resized && chance()) content.resize(file.synchronized.size());
    for (const std::size_t sector : file.written) {
      const std::size_t begin = sector * kSector;
      if (chance() || begin >= content.size()) continue;
      const std::size_t end = std::min(begin + kSector, content.size());
      for (std::size_t at = begin; at < end; ++at) {
        content[at] = at < file.synchronized.size() ? file.synchronized[at] : '\0';
      }
    }
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
  }

  std::mutex mutex_;
  int operations_left_ = 0;
  std::mt19937 random_;
  std::map<std::string, DiskFile> files_;
  std::map<std::string, std::string> deleted_;  ///< whose names may be there again
};

Disk& disk() {
  static Disk disk;
  return disk;
}

/// An open file: SQLite's own one lies behind it in memory.
struct DiskHandle {
  sqlite3_file base;
  sqlite3_file* real;
  const char* path;  ///< nullptr: a temporary one
};

DiskHandle& handleOf(sqlite3_file* file) { return *reinterpret_cast<DiskHandle*>(file); }
sqlite3_file* realOf(sqlite3_file* file) { return handleOf(file).real; }

int closeFile(sqlite3_file* file) { return realOf(file)->pMethods->xClose(realOf(file)); }

int readFile(sqlite3_file* file, void* bytes, int size, sqlite3_int64 offset) {
  return realOf(file)->pMethods->xRead(realOf(file), bytes, size, offset);
}

int writeFile(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset) {
  const char* const path = handleOf(file).path;
  if (path != nullptr) {
    disk().operate();
    disk().wrote(path, static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
  }
  return realOf(file)->pMethods->xWrite(realOf(file), bytes, size, offset);
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size) {
  const char* const path = handleOf(file).path;
  if (path != nullptr) {
    disk().operate();
    disk().truncated(path);
  }
  return realOf(file)->pMethods->xTruncate(realOf(file), size);
}

int synchronizeFile(sqlite3_file* file, int flags) {
  const char* const path = handleOf(file).path;
  if (path != nullptr) disk().operate();
  const int result = realOf(file)->pMethods->xSync(realOf(file), flags);
  if (path != nullptr) disk().synchronized(path);
  return result;
}

int sizeOfFile(sqlite3_file* file, sqlite3_int64* size) {
  return realOf(file)->pMethods->xFileSize(realOf(file), size);
}
int lockFile(sqlite3_file* file, int level) {
  return realOf(file)->pMethods->xLock(realOf(file), level);
}
int unlockFile(sqlite3_file* file, int level) {
  return realOf(file)->pMethods->xUnlock(realOf(file), level);
}
int isReserved(sqlite3_file* file, int* result) {
  return realOf(file)->pMethods->xCheckReservedLock(realOf(file), result);
}
int control(sqlite3_file* file, int operation, void* argument) {
  return realOf(file)->pMethods->xFileControl(realOf(file), operation, argument);
}
int sectorSize(sqlite3_file* file) { return realOf(file)->pMethods->xSectorSize(realOf(file)); }
int characteristics(sqlite3_file* file) {
  return realOf(file)->pMethods->xDeviceCharacteristics(realOf(file));
}

// Version 1: without memory maps, which nobody could watch.
const sqlite3_io_methods kMethods = {
    1,        closeFile,  readFile,   writeFile, truncateFile, synchronizeFile, sizeOfFile,
    lockFile, unlockFile, isReserved, control,   sectorSize,   characteristics, nullptr,
    nullptr,  nullptr,    nullptr,    nullptr,   nullptr};

sqlite3_vfs* real_vfs = nullptr;

int openFile(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags,
             int* out_flags) {
  DiskHandle& handle = handleOf(file);
  handle.base.pMethods = nullptr;
  handle.real = reinterpret_cast<sqlite3_file*>(&handle + 1);
  handle.path = name;
  const bool was_there = name != nullptr && fs::exists(name);
  if (name != nullptr && !was_there) disk().operate();
  const int result = real_vfs->xOpen(real_vfs, name, handle.real, flags, out_flags);
  if (handle.real->pMethods != nullptr) handle.base.pMethods = &kMethods;
  if (result == SQLITE_OK && name != nullptr) disk().opened(name, was_there);
  return result;
}

int deleteFile(sqlite3_vfs* /*vfs*/, const char* name, int synchronize) {
  disk().operate();
  disk().deletes(name, synchronize != 0);
  return real_vfs->xDelete(real_vfs, name, synchronize);
}

}  // namespace

void letPowerFail(int operation, unsigned seed) {
  static sqlite3_vfs vfs;
  disk().failAt(operation, seed);
  real_vfs = sqlite3_vfs_find(nullptr);
  vfs = *real_vfs;  // the rest is as the real one does it
  vfs.zName = "power-cut";
  vfs.szOsFile = static_cast<int>(sizeof(DiskHandle)) + real_vfs->szOsFile;
  vfs.xOpen = openFile;
  vfs.xDelete = deleteFile;
  sqlite3_vfs_register(&vfs, 1);
}

}  // namespace place_memory
