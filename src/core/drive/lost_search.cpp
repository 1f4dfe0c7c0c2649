#include "core/drive/lost_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_memory::core {
namespace {

constexpr int kBearings = 24;       // in which room is looked for
constexpr double kLooks = 0.4;      // a sonar that looks so near to a bearing tells its room [rad]
constexpr double kUnheard = 1.2;    // room that is taken to be where no sonar looks [m]
constexpr double kLeastStep = 0.5;  // [m]
constexpr double kSpacing = 0.5;    // of the spots that are remembered [m]
constexpr double kNear = 0.7;       // a spot so near to a barred one is barred [m]
constexpr double kNew = 2.0;        // so far from where it was everything is new [m]
constexpr double kStraight = 0.5;   // it does not turn for so much more room [m]

double between(const Pose2d& one, const Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

double nearest(const std::vector<Pose2d>& spots, const Pose2d& spot) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pose2d& each : spots) least = std::min(least, between(each, spot));
  return least;
}

}  // namespace

void LostSearch::follow(const Pose2d& odom_from_base, std::chrono::nanoseconds now) {
  if (last_) {
    way_ += between(last_->odom_from_base, odom_from_base);
    time_ += std::chrono::duration<double>(now - last_->stamp).count();
  }
  last_ = Moment{odom_from_base, now};
  if (nearest(visited_, odom_from_base) > kSpacing) visited_.push_back(odom_from_base);
}

bool LostSearch::isBarred(const Pose2d& spot) const { return nearest(barred_, spot) < kNear; }

double LostSearch::newness(const Pose2d& spot) const {
  return std::min(nearest(visited_, spot), kNew);
}

void LostSearch::decide(const std::vector<Pose2d>& advised, const EchoRing& echoes,
                        std::chrono::nanoseconds now) {
  if (!last_) return;
  is_advised_ = !advised.empty() && !isBarred(advised.front());
  target_ = is_advised_ ? advised.front() : roomiest(echoes, now);
}

std::optional<Pose2d> LostSearch::roomiest(const EchoRing& echoes,
                                           std::chrono::nanoseconds now) const {
  std::optional<Pose2d> best;
  double most = 0.0;
  for (int i = 0; i < kBearings; ++i) {
    const double bearing = 2.0 * kPi * i / kBearings;
    const double heard = echoes.along(now, bearing, options_.radius + options_.clearance);
    const double room = echoes.looks(now, bearing, kLooks) ? heard : std::min(heard, kUnheard);
    const double step = std::min(room - options_.radius - 2.0 * options_.clearance, options_.step);
    if (step < kLeastStep) continue;
    const Pose2d spot = last_->odom_from_base * Pose2d{0.0, 0.0, bearing} * Pose2d{step, 0.0, 0.0};
    if (isBarred(spot)) continue;
    const double worth = step + newness(spot) + kStraight * std::cos(bearing);
    if (best && worth <= most) continue;
    best = spot;
    most = worth;
  }
  return best;
}

void LostSearch::arrived() { target_.reset(); }

void LostSearch::blocked() {
  if (target_) barred_.push_back(*target_);
  target_.reset();
}

}  // namespace place_memory::core
