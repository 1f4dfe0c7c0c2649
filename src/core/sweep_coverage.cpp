#include "place_memory/core/sweep_coverage.h"

#include <algorithm>
#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

SweepCoverage::SweepCoverage(int headings, double step) : headings_(headings), step_(step) {
  const int in_a_turn = static_cast<int>(std::lround(2.0 * kPi / step));
  if (headings >= in_a_turn) headings_ = full_turn_ = in_a_turn;
}

void SweepCoverage::add(const std::string& sensor, double base_yaw) {
  if (last_yaw_) turned_ += wrapAngle(base_yaw - *last_yaw_);
  last_yaw_ = base_yaw;
  current_ = static_cast<int>(std::lround(turned_ / step_));
  if (full_turn_ > 0) current_ = ((current_ % full_turn_) + full_turn_) % full_turn_;
  ++readings_at_[current_];
  if (++readings_of_[sensor] > 1) sensors_known_ = true;
}

int SweepCoverage::completed() const {
  const auto latest = readings_at_.find(current_);
  if (latest == readings_at_.end()) return 0;
  const bool latest_is_over =
      sensors_known_ && latest->second >= static_cast<int>(readings_of_.size());
  return latest_is_over ? headings() : headings() - 1;
}

double SweepCoverage::fraction() const {
  return std::min(1.0, static_cast<double>(completed()) / headings_);
}

}  // namespace place_memory::core
