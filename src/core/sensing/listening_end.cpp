#include "core/sensing/listening_end.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr std::chrono::nanoseconds kSilence = std::chrono::milliseconds(500);

}  // namespace

bool ListeningEnd::update(std::chrono::nanoseconds now, const SweepBuilder& sweep) {
  if (sweep.readings().size() != readings_) {
    readings_ = sweep.readings().size();
    last_reading_ = now;
  }
  if (readings_ < min_readings_) return false;
  const SweepCoverage& coverage = sweep.coverage();
  const bool silent = now - last_reading_ > std::max(kSilence, 2 * sweep.longestGap());
  return coverage.done() || (silent && coverage.headings() >= coverage.target());
}

}  // namespace place_memory::core
