#ifndef PLACE_MEMORY_CORE_STORE_UNFINISHED_FILE_H
#define PLACE_MEMORY_CORE_STORE_UNFINISHED_FILE_H

#include <string>

namespace place_memory::core {

/// A file that is being made beside the one it is to become, under the name of that one with
/// ".new-" and numbers: whenever the work is cut off, nothing half-made bears the name. It goes
/// with this object unless it was given its name. Failures throw std::filesystem::filesystem_error.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  const std::string& name() const { return name_; }

  /// Gives it its name, unless another file has it by now: that one stays.
  void publish();
  /// Gives it its name in the place of the file that has it, in one step.
  void publishOver();

 private:
  void settle() const;

  std::string path_;
  std::string name_;
  int lock_ = -1;  ///< says to removeUnfinished() that somebody is at work on it
};

/// Removes what is left of work on `path` that was cut off.
void removeUnfinished(const std::string& path);

/// Another name for the file, which keeps it when its own name goes to another one: the first that
/// is free of `path`.`word`, `path`.`word`-2 and so on. Returns it. Throws filesystem_error.
std::string keepFileAs(const std::string& path, const std::string& word);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_UNFINISHED_FILE_H
