#ifndef PLACE_MEMORY_NODE_ANSWER_KEPT_SCANS_H
#define PLACE_MEMORY_NODE_ANSWER_KEPT_SCANS_H

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "place_memory/core/scan.h"

namespace place_memory::node {

/// The scan that a client asked for, or why there is none.
struct ScanChoice {
  enum class Problem {
    kNone,
    kNoScan,   ///< none was finished yet, or time has run backwards since
    kUnknown,  ///< no scan that is kept has the id
    kTooOld,
  };

  Problem problem = Problem::kNone;
  std::string message;                     ///< what to do about it, a sentence; with kNone what
                                           ///< should be known of the scan, or ""
  std::shared_ptr<const core::Scan> scan;  ///< set with kNone
};

/// The newest scans, which may be learned or recognized. Thread-safe.
class KeptScans {
 public:
  static constexpr std::size_t kMost = 16;

  /// A scan that lies back longer than `max_age` [s] is refused.
  explicit KeptScans(double max_age);

  void add(std::shared_ptr<const core::Scan> scan);
  void drop();
  /// A scan runs that is not among these yet: who asks for the newest one is told.
  void setUnderWay(bool under_way);

  /// `id` 0: the newest. `now` is on the clock of Scan::end.
  ScanChoice choose(std::uint64_t id, std::chrono::nanoseconds now) const;

 private:
  std::shared_ptr<const core::Scan> find(std::uint64_t id) const;

  const double max_age_;
  mutable std::mutex mutex_;
  std::deque<std::shared_ptr<const core::Scan>> scans_;  // by rising age
  bool under_way_ = false;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_KEPT_SCANS_H
