#ifndef PLACE_MEMORY_NODE_SCAN_COMPASS_HEALTH_H
#define PLACE_MEMORY_NODE_SCAN_COMPASS_HEALTH_H

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include "core/sensing/recent_count.h"

namespace place_memory::node {

/// How the compass is.
struct CompassHealth {
  bool heard = false;                  ///< ever
  std::uint32_t messages = 0;          ///< within the last ten seconds
  std::uint32_t left_out = 0;          ///< of them
  std::string problem;                 ///< why the newest of those was left out, in a sentence
  std::chrono::nanoseconds silent{0};  ///< since the newest message
  std::string doubt;  ///< what does not fit odometry, in a sentence; empty: nothing
};

/// What comes of the compass' messages. `now` is a time that never goes back.
class CompassHealthCount {
 public:
  void noteMessage(std::chrono::nanoseconds now) {
    heard_ = true;
    newest_ = now;
    messages_.add(now);
  }

  void noteLeftOut(std::string problem, std::chrono::nanoseconds now) {
    left_out_.add(now);
    problem_ = std::move(problem);
  }

  CompassHealth report(std::chrono::nanoseconds now) const {
    return {heard_, messages_.at(now), left_out_.at(now), problem_, now - newest_, {}};
  }

 private:
  bool heard_ = false;
  std::chrono::nanoseconds newest_{0};
  core::RecentCount messages_;
  core::RecentCount left_out_;
  std::string problem_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_COMPASS_HEALTH_H
