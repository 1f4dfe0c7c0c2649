#include "core/mapping/continuity_watch.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kReach = 0.5;                     ///< way on either side that is compared [m]
constexpr double kNewSpot = 0.02;                  // [m]
constexpr double kNewHeading = 2.0 * kPi / 180.0;  // [rad]
constexpr std::size_t kMostAtSpot = 16;            // readings
constexpr std::size_t kMostRays = 64;              // of either side
constexpr std::size_t kStep = 3;                   // stations from one that is judged to the next
constexpr int kFewestKnown = 24;                   // echoes to judge by
constexpr double kPriorEchoes = 30.0;              ///< that fit as they mostly do, against chance
constexpr double kSame = 0.1;                      ///< difference of ranges that is none [m]
constexpr double kFree = 0.2;                      ///< so far before an echo nothing is [m]
constexpr double kLearns = 0.1;                    ///< weight of a spot in what is usual

// Log odds of an echo to intrude, beyond the usual; chosen on drives of seeds from 100 on.
constexpr double kFalters = 0.3;
constexpr double kBreaks = 0.7;
constexpr double kSurelyBreaks = 1.1;
// Or so many times as far beyond as they mostly are: narrow cones along a wall now hear it, now
// not.
constexpr double kOftenBreaks = 4.0;
constexpr double kOftenSurelyBreaks = 6.0;
constexpr double kMostSpread = 0.5;             ///< of one spot: it may be where it was carried
constexpr double kTurned = 25.0 * kPi / 180.0;  ///< more than iron turns a compass [rad]

double logOdds(double share) { return std::log((share + 0.02) / (1.02 - share)); }

}  // namespace

void ContinuityWatch::add(const BaseMoment& moment, const SonarReading& reading,
                          std::optional<double> heading) {
  const Pose2d& base = moment.reckoned;
  if (stations_.empty() || moment.way - stations_.back().way > kNewSpot ||
      std::abs(wrapAngle(base.yaw - stations_.back().yaw)) > kNewHeading) {
    stations_.push_back({moment.way, base.yaw, std::nullopt, {}});
    if (heading) stations_.back().deviation = wrapAngle(*heading - base.yaw);
  }
  std::vector<Ray>& rays = stations_.back().rays;
  if (rays.size() < kMostAtSpot) {
    const Pose2d sensor = base * reading.sensor_pose;
    rays.push_back({sensor.x, sensor.y, std::cos(sensor.yaw), std::sin(sensor.yaw),
                    std::cos(0.5 * reading.spec.field_of_view), reading.range,
                    std::min(reading.range, reading.spec.max_range) - kFree});
  }
  while (next_ + 1 < stations_.size() && moment.way - stations_[next_].way >= kReach) {
    judge(next_);
    next_ = std::min(next_ + kStep, stations_.size() - 1);
  }
  while (next_ > 0 && stations_[next_].way - stations_.front().way > kReach) {
    stations_.pop_front();
    --next_;
  }
}

void ContinuityWatch::count(const std::vector<Ray>& echoes, const std::vector<Ray>& others,
                            Fit& fit) {
  for (const Ray& echo : echoes) {
    if (!std::isfinite(echo.range)) continue;
    const double x = echo.x + echo.range * echo.cosine, y = echo.y + echo.range * echo.sine;
    bool is_explained = false, intrudes = false;
    for (const Ray& other : others) {
      const double dx = x - other.x, dy = y - other.y;
      const double distance = std::sqrt(dx * dx + dy * dy);
      if (dx * other.cosine + dy * other.sine < distance * other.half_cosine) continue;
      is_explained = is_explained || std::abs(distance - other.range) < kSame;
      intrudes = intrudes || distance < other.free;
    }
    fit.explained += is_explained ? 1 : 0;
    fit.intruding += intrudes && !is_explained ? 1 : 0;
  }
}

ContinuityWatch::Side ContinuityWatch::side(std::size_t first, std::size_t last) const {
  Side side;
  std::size_t count = 0;
  double sine = 0.0, cosine = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    count += stations_[i].rays.size();
    if (!stations_[i].deviation) continue;
    sine += std::sin(*stations_[i].deviation);
    cosine += std::cos(*stations_[i].deviation);
  }
  if (sine != 0.0 || cosine != 0.0) side.deviation = std::atan2(sine, cosine);
  const double share =
      static_cast<double>(kMostRays) / static_cast<double>(std::max(count, kMostRays));
  double due = 0.5;
  for (std::size_t i = first; i < last; ++i) {
    for (const Ray& ray : stations_[i].rays) {
      due += share;
      if (due < 1.0) continue;
      due -= 1.0;
      side.rays.push_back(ray);
    }
  }
  return side;
}

void ContinuityWatch::judge(std::size_t station) {
  const double way = stations_[station].way;
  std::size_t first = station, last = station;
  while (first > 0 && way - stations_[first - 1].way <= kReach) --first;
  while (last < stations_.size() && stations_[last].way - way <= kReach) ++last;
  const Side before = side(first, station), after = side(station, last);
  if (before.deviation && after.deviation) {
    const double turned = std::abs(wrapAngle(*after.deviation - *before.deviation));
    if (turned > turned_.value_or(-1.0)) {
      turned_ = turned;
      turned_way_ = way;
    }
  }
  Fit fit;
  count(before.rays, after.rays, fit);
  count(after.rays, before.rays, fit);
  const int known = fit.explained + fit.intruding;
  if (known < kFewestKnown) return;
  const double share = (fit.intruding + kPriorEchoes * usual_) / (known + kPriorEchoes);
  if (worst_ && share <= *worst_) return;
  worst_ = share;
  worst_way_ = way;
}

Spot ContinuityWatch::take() {
  Spot spot;
  spot.way = worst_way_;
  if (turned_) {
    const bool otherwise = *turned_ > kTurned;
    spot.compass = otherwise ? CompassTurn::kOtherwise : CompassTurn::kAsOdometry;
    if (otherwise) spot.way = turned_way_;
  }
  if (worst_) {
    const double beyond = logOdds(*worst_) - logOdds(usual_);
    const double breaks = std::max(kBreaks, kOftenBreaks * spread_);
    const double surely = std::max(kSurelyBreaks, kOftenSurelyBreaks * spread_);
    spot.readings = beyond > surely     ? Continuity::kSurelyBreaks
                    : beyond > breaks   ? Continuity::kBreaks
                    : beyond > kFalters ? Continuity::kFalters
                                        : Continuity::kGoesOn;
    spread_ += kLearns * (std::min(std::abs(beyond), kMostSpread) - spread_);
    usual_ += kLearns * (*worst_ - usual_);
  }
  worst_.reset();
  turned_.reset();
  return spot;
}

void ContinuityWatch::restart() {
  stations_.clear();
  next_ = 0;
  worst_.reset();
  turned_.reset();
}

}  // namespace place_memory::core
