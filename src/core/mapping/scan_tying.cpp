#include "core/mapping/scan_tying.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/grid/cell_shift.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;

constexpr double kTieReach = 2.4;  ///< how far off the places are that a scan is tied to [m]
constexpr int kMostTies = 4;
/// What both grids owe to noise, beside what the alignment shows.
constexpr double kTieNoise = 0.06;  // [m]
constexpr double kTieTurnNoise = 2.0 * kDegree;
constexpr double kTieTurn = 10.0 * kDegree;
constexpr double kDeviates = 45.0 * kDegree;  ///< from what the compass showed there before
constexpr double kDeviating = 0.2;            ///< share of a probability that remains then
constexpr double kTrackWindow = 15.0 * kDegree;
/// Of sonars that look ahead: what they see from the other side hardly ever looks alike beyond
/// doubt, but by chance it looks alike just where it is expected more rarely still.
constexpr double kExpected = 0.02;
constexpr double kMostTurned = 15.0 * kDegree;  ///< that odometry is trusted to have mistaken

/// The grid's content moved by whole cells.
EvidenceGrid shifted(const EvidenceGrid& grid, CellShift shift) {
  EvidenceGrid moved(grid.geometry());
  const int first = std::max(0, shift.columns);
  const int last = std::min(kGridSize, kGridSize + shift.columns);
  for (int row = std::max(0, shift.rows); row < std::min(kGridSize, kGridSize + shift.rows);
       ++row) {
    for (int column = first; column < last; ++column) {
      moved.add(row, column, grid.at(row - shift.rows, column - shift.columns));
    }
  }
  return moved;
}

/// A covariance as a frame turned by `yaw` has it.
Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, double yaw) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);
  return turn * covariance * turn.transpose();
}

}  // namespace

LaidScan ScanTying::lay(NodeIndex node, const Pose2d& map_from_base) const {
  const ScanNode& scan = graph_.node(node);
  const Pose2d grid_from_base = baseFromGrid(scan, map_from_base.yaw).inverse();
  return {sonar_.build(movedReadings(*scan.readings, grid_from_base), geometry_), grid_from_base,
          map_from_base, scan.compass};
}

std::vector<Sighting> ScanTying::sightings(const std::vector<PlaceFit>& fits,
                                           const LaidScan& scan) const {
  std::vector<Sighting> seen;
  seen.reserve(fits.size());
  for (const PlaceFit& fit : fits) {
    const ScanNode& place = graph_.node(shelf_.nodeOf(fit.id));
    Sighting sighting{fit.id, fit.probability,
                      place.pose * baseFromGrid(place, place.laid_yaw) * fit.place_from_scan *
                          scan.grid_from_base};
    const std::optional<double> deviation = graph_.compassDeviation(shelf_.nodeOf(fit.id));
    if (scan.compass && deviation &&
        std::abs(wrapAngle(*scan.compass - sighting.pose.yaw - *deviation)) > kDeviates) {
      sighting.probability *= kDeviating;
    }
    seen.push_back(sighting);
  }
  return seen;
}

std::optional<Pose2d> ScanTying::whereTracked(NodeIndex node, const LaidScan& scan,
                                              const std::vector<Sighting>& seen, WaySearch& ways,
                                              const SigmaTo& sigma_to, bool near_only) const {
  const Pose2d& estimate = scan.map_from_base;
  std::optional<Pose2d> expected;
  for (const Sighting& sighting : seen) {
    const double off = std::hypot(sighting.pose.x - estimate.x, sighting.pose.y - estimate.y);
    const double turn = std::abs(wrapAngle(sighting.pose.yaw - estimate.yaw));
    const double sigma = sigma_to(sighting.place);
    if (sigma > kTrackSigma) continue;
    const bool close = off <= 0.5 && turn <= 8.0 * kDegree && sighting.probability >= 0.3;
    const bool sure =
        !near_only && off <= 1.0 && turn <= 15.0 * kDegree && sighting.probability >= 0.82;
    if ((close || sure) && off <= 0.3 + 3.0 * sigma) return estimate;
    if (expected || !graph_.node(node).looksAhead() || sighting.probability < kExpected) continue;
    double turned = 0.0;
    if (!scan.compass) {
      const double way = ways.to(shelf_.nodeOf(sighting.place)).value_or(kFarthestWay);
      turned = std::min(std::hypot(yawSigma(way), graph_.errorSigmas().bend * way), kMostTurned);
    }
    if (off <= 0.3 + sigma && turn <= 8.0 * kDegree + turned) expected = sighting.pose;
  }
  return expected;
}

bool ScanTying::track(NodeIndex node, const LaidScan& scan, const std::vector<PlaceFit>& fits,
                      WaySearch& ways, double most_sigma, bool near_only, int closure) {
  const bool compass = graph_.node(node).compass.has_value();
  const SigmaTo sigma_to = [&](PlaceId id) {
    const std::optional<double> way = ways.to(shelf_.nodeOf(id));
    return way ? std::min(positionSigma(*way, compass), most_sigma) : most_sigma;
  };
  const std::optional<Pose2d> there =
      whereTracked(node, scan, sightings(fits, scan), ways, sigma_to, near_only);
  if (!there) return false;
  const LaidScan laid = lay(node, *there);
  int ties = 0;
  const int session = graph_.node(node).session;
  for (const PlaceShelf::Near& near :
       shelf_.nearSeen(*there, graph_.node(node).seen, session, kTieReach)) {
    if (ties == kMostTies) break;
    const double sigma = sigma_to(near.id);
    if (sigma > kTrackSigma) continue;
    const double reach = std::min(1.0, 0.3 + 3.0 * sigma);
    ties += tie(near.id, node, laid, reach, kTrackWindow, closure) ? 1 : 0;
  }
  return ties > 0;
}

bool ScanTying::tie(PlaceId id, NodeIndex node, const LaidScan& scan, double near, double window,
                    int closure) {
  const NodeIndex at = shelf_.nodeOf(id);
  const ScanNode& place = graph_.node(at);
  const Pose2d base_from_grid = baseFromGrid(place, place.laid_yaw);
  const Pose2d expected =
      (place.pose * base_from_grid).inverse() * scan.map_from_base * scan.grid_from_base.inverse();
  // Moved by whole cells to about the place's middle, within the reach of the search; what is left
  // of the distance is for the alignment to tell.
  const double cell = geometry_.cell_size;
  const CellShift shift{static_cast<int>(std::lround(expected.x / cell)),
                        static_cast<int>(std::lround(expected.y / cell))};
  const Pose2d moved{shift.columns * cell, shift.rows * cell, 0.0};
  const PlaceMatcher& matcher = *shelf_.matcher(place.session);
  const PlaceFit fit = matcher.align(shifted(scan.grid, shift), id, window);
  const Pose2d found = fit.place_from_scan * moved;
  if (std::hypot(found.x - expected.x, found.y - expected.y) > near) return false;
  if (std::abs(wrapAngle(found.yaw - expected.yaw)) > kTieTurn) return false;
  // The alignment turns about the place, the robot stands aside.
  const Pose2d there = found * scan.grid_from_base;
  Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
  lever(0, 2) = -(there.y - fit.place_from_scan.y);
  lever(1, 2) = there.x - fit.place_from_scan.x;
  Eigen::Matrix3d covariance = fit.covariance;
  covariance.diagonal() +=
      Eigen::Vector3d(kTieNoise * kTieNoise, kTieNoise * kTieNoise, kTieTurnNoise * kTieTurnNoise);
  covariance = turned(lever * covariance * lever.transpose(), base_from_grid.yaw);
  graph_.tie({at, node, base_from_grid * there, covariance.inverse(), closure});
  return true;
}

}  // namespace place_memory::core
