#include "core/sensing/sweep_coverage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr int kPatience = 20;  // [turns of another sensor]

}  // namespace

SweepCoverage::SweepCoverage(int headings, double step, std::set<SensorId> sensors)
    : headings_(headings), step_(step), sensors_(std::move(sensors)) {
  const int in_a_turn = static_cast<int>(std::lround(2.0 * kPi / step));
  if (headings >= in_a_turn) headings_ = full_turn_ = in_a_turn;
}

void SweepCoverage::add(SensorId sensor, double base_yaw) {
  if (last_yaw_) turned_ += wrapAngle(base_yaw - *last_yaw_);
  last_yaw_ = base_yaw;
  current_ = static_cast<int>(std::lround(turned_ / step_));
  if (full_turn_ > 0) current_ = ((current_ % full_turn_) + full_turn_) % full_turn_;
  takeTurn(sensor);
}

void SweepCoverage::skip(SensorId sensor) {
  // Others are not waited for, and may be without number.
  if (last_yaw_ && sensors_.count(sensor) > 0) takeTurn(sensor);
}

void SweepCoverage::takeTurn(SensorId sensor) {
  sensors_.insert(sensor);
  if (!heard_.insert(sensor).second) sensors_known_ = true;
  std::map<SensorId, int>& turns = turns_at_[current_];
  if (++turns[sensor] < kPatience) return;
  for (auto it = sensors_.begin(); it != sensors_.end();) {
    it = turns.count(*it) > 0 ? std::next(it) : sensors_.erase(it);
  }
}

int SweepCoverage::completed() const {
  const auto latest = turns_at_.find(current_);
  if (latest == turns_at_.end()) return 0;
  const auto hadItsTurn = [&](SensorId sensor) { return latest->second.count(sensor) > 0; };
  const bool latest_is_over =
      sensors_known_ && std::all_of(sensors_.begin(), sensors_.end(), hadItsTurn);
  return latest_is_over ? headings() : headings() - 1;
}

double SweepCoverage::fraction() const {
  return std::min(1.0, static_cast<double>(completed()) / headings_);
}

}  // namespace place_memory::core
