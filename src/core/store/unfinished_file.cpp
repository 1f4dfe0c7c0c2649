#include "core/store/unfinished_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <random>
#include <string_view>
#include <system_error>

#include "core/store/store_journal.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

constexpr char kInfix[] = ".new-";

[[noreturn]] void throwErrno(const char* what, const std::string& path) {
  throw fs::filesystem_error(what, path, std::error_code(errno, std::generic_category()));
}

// Another name for each call, of any process.
std::string unfinishedName(const std::string& path) {
  std::random_device random;
  return path + kInfix + std::to_string(random()) + "-" + std::to_string(random());
}

// Puts on the disk what is in the file, or which names are in the folder.
void synchronize(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);  // some file systems know none for folders
  close(file);
}

bool hasName(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && status.st_nlink > 0;
}

// "" where it is no journal's name.
std::string withoutJournal(const std::string& name) {
  constexpr std::string_view kEnding = "-journal";
  const bool is_journal = name.size() > kEnding.size() &&
                          name.compare(name.size() - kEnding.size(), kEnding.size(), kEnding) == 0;
  return is_journal ? name.substr(0, name.size() - kEnding.size()) : "";
}

void removeWithJournal(const std::string& name) {
  std::error_code ignored;
  fs::remove(journalOf(name), ignored);
  fs::remove(name, ignored);
}

// Unless somebody holds it who still works on it.
void removeIfLeft(const fs::path& name) {
  const int file = open(name.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return;
  if (flock(file, LOCK_EX | LOCK_NB) == 0) removeWithJournal(name.string());
  close(file);
}

}  // namespace

UnfinishedFile::UnfinishedFile(const std::string& path) : path_(path) {
  for (;;) {
    name_ = unfinishedName(path);
    lock_ = open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (lock_ < 0) throwErrno("cannot be made", path);
    flock(lock_, LOCK_EX);
    if (hasName(lock_)) return;  // otherwise removeUnfinished() was faster than the lock
    close(lock_);
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (!name_.empty()) removeWithJournal(name_);
  close(lock_);
}

void UnfinishedFile::publish() {
  settle();
  std::error_code error;
  fs::create_hard_link(name_, path_, error);
  if (error && error != std::errc::file_exists) {
    if (!fs::exists(path_)) fs::rename(name_, path_);  // a file system without hard links
  }
  std::error_code ignored;
  fs::remove(name_, ignored);
  name_.clear();
  settle();
}

void UnfinishedFile::publishOver() {
  settle();
  fs::rename(name_, path_);
  name_.clear();
  settle();
}

void UnfinishedFile::settle() const {
  if (!name_.empty()) fsync(lock_);
  synchronize(fs::path(path_).parent_path().string());
}

void removeUnfinished(const std::string& path) {
  const fs::path file(path);
  const std::string prefix = file.filename().string() + kInfix;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    const auto is_ours = [&](const std::string& candidate) {
      return candidate.compare(0, prefix.size(), prefix) == 0 &&
             candidate.find_first_not_of("0123456789-", prefix.size()) == std::string::npos;
    };
    if (is_ours(name) && entry.is_regular_file(ignored)) removeIfLeft(entry.path());
    // The name of a journal that was gone may be there again after the power failed.
    const std::string owner = withoutJournal(name);
    if (is_ours(owner) && !fs::exists(file.parent_path() / owner, ignored)) {
      fs::remove(entry.path(), ignored);
    }
  }
}

std::string keepFileAs(const std::string& path, const std::string& word) {
  std::string name = path + "." + word;
  for (int number = 2;; ++number) {
    std::error_code error;
    if (fs::exists(name)) {
      if (fs::equivalent(name, path)) return name;  // of an attempt that was cut off
    } else {
      fs::create_hard_link(path, name, error);
      if (!error) break;
      if (error != std::errc::file_exists) {  // a file system without hard links
        UnfinishedFile copy(name);
        fs::copy_file(path, copy.name(), fs::copy_options::overwrite_existing);
        copy.publish();
        break;
      }
    }
    name = path + "." + word + "-" + std::to_string(number);
  }
  synchronize(fs::path(path).parent_path().string());
  return name;
}

}  // namespace place_memory::core
