#ifndef PLACE_MEMORY_TEST_ENDURANCE_CHANGE_LOG_H
#define PLACE_MEMORY_TEST_ENDURANCE_CHANGE_LOG_H

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "endurance/map_record.h"

namespace place_memory {

enum class Deed : std::uint8_t {
  kLearn,
  kRecognize,
  kRename,
  kRemove,
  kClear,
  kRelax,     ///< every place is moved, as after a loop was closed on a drive
  kTraverse,  ///< a link learns from it
  kUndo,      ///< the newest change, of whoever made it
  kSetLink,   ///< a link is closed, opened, forbidden, or costs more
  kDrive,     ///< somewhere new, which becomes a place
  kSave,      ///< a copy; the map stays
  kLoad,      ///< that copy
  kMerge,     ///< what that copy has and the map has not
};

/// What somebody has to say who may be killed right after.
struct Said {
  enum class What : std::uint8_t {
    kOpened,    ///< the memory, with this map
    kAsked,     ///< a client, for a deed
    kChanged,   ///< the memory's listener: the map is this one now
    kAnswered,  ///< the client: the deed is done
    kDeclined,  ///< the client: the deed made no sense by then, with the reason
    kFailed,    ///< something that must not be, with the reason
  };

  What what = What::kFailed;
  std::uint32_t client = 0;
  Deed deed = Deed::kLearn;
  std::string text;      ///< the deed's label, or a reason
  std::string new_text;  ///< the label that it is renamed to
  MapRecord map;         ///< where it was opened or changed
};

/// A file that such a process writes. What was said stays, however the process ends.
class ChangeLog {
 public:
  explicit ChangeLog(const std::string& path);
  ~ChangeLog();
  ChangeLog(const ChangeLog&) = delete;
  ChangeLog& operator=(const ChangeLog&) = delete;

  /// Thread-safe.
  void say(const Said& said);

  /// In the order in which it was said. What was being said when the process ended is left out.
  static std::vector<Said> read(const std::string& path);

 private:
  std::mutex mutex_;
  int file_;
};

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_CHANGE_LOG_H
