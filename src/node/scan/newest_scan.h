#ifndef PLACE_MEMORY_NODE_SCAN_NEWEST_SCAN_H
#define PLACE_MEMORY_NODE_SCAN_NEWEST_SCAN_H

#include <memory>
#include <mutex>
#include <utility>

#include "place_memory/core/scan.h"

namespace place_memory::node {

/// The scan that is learned or recognized next. Thread-safe.
class NewestScan {
 public:
  void set(std::shared_ptr<const core::Scan> scan) {
    const std::lock_guard<std::mutex> lock(mutex_);
    scan_ = std::move(scan);
  }

  void drop() { set(nullptr); }

  /// nullptr where there is none.
  std::shared_ptr<const core::Scan> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return scan_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const core::Scan> scan_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_NEWEST_SCAN_H
