#include "core/sensing/compass_watch.h"

#include <algorithm>
#include <vector>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr std::chrono::nanoseconds kPause = std::chrono::milliseconds(50);
constexpr std::chrono::nanoseconds kDrifts = std::chrono::seconds(10);  // a bad gyro, in more
constexpr std::size_t kFewest = 8;
constexpr double kOdometryTurned = 0.2;  // [rad]
constexpr double kCompassTurned = 0.35;  // [rad]
constexpr double kStands = 0.1;          // of what the other one turned
constexpr double kFollows = 0.3;         // of what odometry turned
constexpr std::size_t kMeans = 8;        // of the compass, against its noise

struct Pair {
  double heading;
  double yaw;
};

double spread(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

// How much the compass turns while odometry turns by 1, by least squares.
double slope(const std::vector<Pair>& pairs) {
  Pair mean{0.0, 0.0};
  for (const Pair& p : pairs) {
    mean.heading += p.heading / static_cast<double>(pairs.size());
    mean.yaw += p.yaw / static_cast<double>(pairs.size());
  }
  double both = 0.0;
  double yaw = 0.0;
  for (const Pair& p : pairs) {
    both += (p.heading - mean.heading) * (p.yaw - mean.yaw);
    yaw += (p.yaw - mean.yaw) * (p.yaw - mean.yaw);
  }
  return both / yaw;
}

// By how much the headings differ once their noise is averaged.
double turnedBy(const std::vector<Pair>& pairs) {
  std::vector<double> means;
  const std::size_t each = std::max<std::size_t>(1, pairs.size() / kMeans);
  for (std::size_t first = 0; first + each <= pairs.size(); first += each) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + each; ++i) sum += pairs[i].heading;
    means.push_back(sum / static_cast<double>(each));
  }
  return spread(means);
}

double odometryOf(const std::vector<Pair>& pairs) {
  std::vector<double> yaws;
  yaws.reserve(pairs.size());
  for (const Pair& p : pairs) yaws.push_back(p.yaw);
  return spread(yaws);
}

}  // namespace

void CompassWatch::add(std::chrono::nanoseconds stamp, double heading, double yaw) {
  if (!samples_.empty() && stamp < samples_.back().stamp) samples_.clear();
  if (!samples_.empty()) {
    const Sample& last = samples_.back();
    if (stamp - last.stamp < kPause) return;
    heading = last.heading + wrapAngle(heading - last.heading);
    yaw = last.yaw + wrapAngle(yaw - last.yaw);
  }
  samples_.push_back({stamp, heading, yaw});
  if (samples_.size() > kMost) samples_.pop_front();
}

std::optional<std::chrono::nanoseconds> CompassWatch::newest() const {
  if (samples_.empty()) return std::nullopt;
  return samples_.back().stamp;
}

bool CompassWatch::agree(std::chrono::nanoseconds from) const {
  std::vector<Pair> all;
  for (const Sample& s : samples_) {
    if (s.stamp >= from) all.push_back({s.heading, s.yaw});
  }
  return all.size() >= kFewest && odometryOf(all) >= kOdometryTurned && slope(all) >= kFollows;
}

std::optional<CompassWatch::Finding> CompassWatch::find(std::chrono::nanoseconds from) const {
  std::vector<Pair> all;
  std::vector<Pair> late;
  for (const Sample& s : samples_) {
    if (s.stamp < from) continue;
    all.push_back({s.heading, s.yaw});
    if (s.stamp > samples_.back().stamp - kDrifts) late.push_back({s.heading, s.yaw});
  }
  if (all.size() < kFewest) return std::nullopt;
  const double odometry = odometryOf(all);
  if (odometry >= kOdometryTurned) {
    const double follows = slope(all);
    if (follows >= kFollows) return std::nullopt;
    const Fault fault = follows > -kFollows ? Fault::kCompassStands : Fault::kCompassOtherWay;
    return Finding{fault, follows * odometry, odometry};
  }
  if (late.size() < kFewest) return std::nullopt;
  const double compass = turnedBy(late);
  if (compass < kCompassTurned || odometryOf(late) > kStands * compass) return std::nullopt;
  return Finding{Fault::kOdometryStands, compass, odometryOf(late)};
}

}  // namespace place_memory::core
