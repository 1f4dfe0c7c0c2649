#include "core/views/expected_view.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kStep = 2.0 * kPi / kViewBearings;
constexpr SonarSpec kSonar{kStep, 0.2, 4.0};  // that hears it
constexpr double kSector = 0.25 * kPi;        // to either side

constexpr double kApart = 0.6;       // ranges that differ by more part two views [m]
constexpr double kSeen = 1.5;        // a bearing is known that is clear so far [m]
constexpr double kBeside = 0.3;      // the robot may stand so far beside [m]
constexpr int kTolerated = 1;        // bearings that part views of one spot
constexpr double kPerBearing = 0.7;  // log likelihood of each further one; neighbours repeat it
constexpr double kLeast = 0.01;      // what is there changes, and grids err

/// False where one of them does not know.
bool isParted(const GridView& one, const GridView& other) {
  if (one.echo && other.echo) return std::abs(*one.echo - *other.echo) > kApart;
  if (one.echo) return other.clear > *one.echo + kApart;
  return other.echo && one.clear > *other.echo + kApart;
}

}  // namespace

double bearingOf(std::size_t index) { return wrapAngle(kStep * static_cast<double>(index)); }

ExpectedView expectedView(const EvidenceGrid& grid, const Pose2d& grid_from_robot) {
  ExpectedView view;
  for (std::size_t i = 0; i < kViewBearings; ++i) {
    view[i] = viewFrom(grid, grid_from_robot * Pose2d{0.0, 0.0, bearingOf(i)}, kSonar);
  }
  return view;
}

Bearings knownOf(const ExpectedView& view) {
  Bearings known{};
  for (std::size_t i = 0; i < kViewBearings; ++i) {
    known[i] = view[i].echo.has_value() || view[i].clear >= kSeen;
  }
  return known;
}

Bearings sectorAbout(std::size_t index) {
  Bearings sector{};
  for (std::size_t i = 0; i < kViewBearings; ++i) {
    sector[i] = std::abs(wrapAngle(bearingOf(i) - bearingOf(index))) <= kSector + 1e-9;
  }
  return sector;
}

std::vector<ExpectedView> viewsAbout(const EvidenceGrid& grid, const Pose2d& grid_from_robot) {
  std::vector<ExpectedView> views;
  for (const double x : {0.0, -kBeside, kBeside}) {
    for (const double y : {0.0, -kBeside, kBeside}) {
      views.push_back(
          expectedView(grid, {grid_from_robot.x + x, grid_from_robot.y + y, grid_from_robot.yaw}));
    }
  }
  return views;
}

double likeness(const ExpectedView& view, const std::vector<ExpectedView>& others,
                const Bearings& counted) {
  int least = static_cast<int>(kViewBearings);
  for (const ExpectedView& other : others) {
    int parted = 0;
    for (std::size_t i = 0; i < kViewBearings; ++i) {
      if (counted[i] && isParted(view[i], other[i])) ++parted;
    }
    least = std::min(least, parted);
  }
  return std::max(std::exp(-kPerBearing * std::max(least - kTolerated, 0)), kLeast);
}

}  // namespace place_memory::core
