#ifndef PLACE_MEMORY_NODE_SCAN_COMPASS_DOUBT_H
#define PLACE_MEMORY_NODE_SCAN_COMPASS_DOUBT_H

#include <chrono>
#include <string>

#include "config/parameters.h"
#include "core/sensing/compass_watch.h"
#include "core/sensing/heading_history.h"
#include "node/scan/reading_locator.h"

namespace place_memory::node {

/// Compares compass and odometry all the time, and says what does not fit.
class CompassDoubt {
 public:
  /// All must outlive it.
  CompassDoubt(const config::Parameters& parameters, const ReadingLocator& locator,
               const core::HeadingHistory& headings)
      : parameters_(parameters), locator_(locator), headings_(headings) {}

  /// To be called again and again: takes what is new.
  void observe();
  /// A scan begins at the stamp.
  void beginScan(std::chrono::nanoseconds start);
  /// Time was set.
  void clear() {
    watch_.clear();
    now_.clear();
  }

  /// What is wrong, in a sentence, until a turn shows that it no longer is; empty: nothing.
  const std::string& now() const { return now_; }
  /// What was wrong since the scan began, likewise.
  const std::string& ofScan() const { return of_scan_; }

 private:
  std::string find(std::chrono::nanoseconds from) const;

  const config::Parameters& parameters_;
  const ReadingLocator& locator_;
  const core::HeadingHistory& headings_;
  core::CompassWatch watch_;
  std::chrono::nanoseconds scan_start_{0};
  std::string now_;
  std::string of_scan_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_COMPASS_DOUBT_H
