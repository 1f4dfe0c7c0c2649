#include "node/input/shared_frame_watch.h"

namespace place_memory::node {
namespace {

// A message that is sent again with a mended range is nothing to speak of.
constexpr int kShows = 5;

}  // namespace

bool SharedFrameWatch::note(core::SensorId sensor, std::chrono::nanoseconds stamp, double range) {
  const auto [known, is_new] = last_.try_emplace(sensor);
  Last& last = known->second;
  // NaN is unequal to itself: one that is sent twice is no second sensor.
  const bool differs = range < last.range || range > last.range;
  if (!is_new && stamp == last.stamp && differs && last.shared < kShows) ++last.shared;
  last.stamp = stamp;
  last.range = range;
  return last.shared >= kShows;
}

}  // namespace place_memory::node
