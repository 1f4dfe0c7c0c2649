// What a scan shows of where the robot is.
#include <algorithm>
#include <cmath>

#include "core/mapping/mapper.h"
#include "core/mapping/odometry_reach.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kAtPlace = 0.6;  ///< so near to a place a scan should show it [m]
constexpr double kCompassWindow = 45.0 * kDegree;
constexpr double kCompassAgrees = 30.0 * kDegree;
constexpr double kToldSigma = 0.3;   ///< of where a person says that the robot is [m]
constexpr double kUseful = 0.3;      ///< probability of a match that is worth something
constexpr double kLongUntied = 5.0;  ///< way after which every heading is looked at [m]

// Of the way's covariance: beyond the farthest a loop is none, but the robot was carried; up to the
// free ones it costs no evidence.
constexpr double kFreeSigmas = 1.5;
constexpr double kFarthestSigmas = 4.5;
constexpr double kOneSide = 60.0 * kDegree;

}  // namespace

double Mapper::headingWindow() const {
  const ScanNode& node = graph_.nodes().back();
  if (!node.compass) return kCompassWindow;
  if (session_ != kMapSession && !compass_guides_) return kPi;
  const bool agrees = std::abs(wrapAngle(*node.compass - node.pose.yaw)) < kCompassAgrees;
  return agrees ? kCompassWindow : kPi;
}

std::vector<PlaceFit> Mapper::recognizeAnyhow(const PlaceMatcher& places, const LaidScan& scan,
                                              const std::vector<PlaceFit>& fits) const {
  const bool sure = !fits.empty() && fits.front().probability >= kUseful;
  const bool compass = graph_.nodes().back().compass.has_value();
  if (sure || compass || reckoning_.way() - anchored_way_ < kLongUntied) return fits;
  return places.recognize(scan.grid, kPi);
}

void Mapper::lookForOwnSession(NodeIndex at, View& view) {
  const PlaceMatcher* own = shelf_.matcher(session_);
  if (!own) return;
  const std::vector<PlaceFit> fits = own->recognize(view.laid.grid, headingWindow());
  if (session_ == kMapSession) believe(at, fits, view.laid);
  WaySearch ways(graph_, at, kFarthestWay);
  // A scan that was begun where the robot was carried from still looks like there.
  if (!view.agreement.contradicts && !straddlesBreak(at)) {
    view.tracked = tying_.track(at, view.laid, fits, ways, mostSigma(at), view.agreement.disagrees,
                                closer_.onTrial());
  }
  view.best = fits.empty() ? 0.0 : fits.front().probability;
  sortOut(tying_.sightings(view.tracked ? fits : recognizeAnyhow(*own, view.laid, fits), view.laid),
          at, ways, view);
}

// How well it is known where any place is, however long the way to it: by a person's word, or
// because the map stays, so that where one place is tells where all are.
double Mapper::mostSigma(NodeIndex at) const {
  const bool compass = graph_.node(at).compass.has_value();
  const double untied = positionSigma(untiedWay(), compass);
  if (is_told_) return std::hypot(kToldSigma, untied);
  return options_.mode == MapperMode::kLocalize ? untied : positionSigma(kFarthestWay, compass);
}

Mapper::View Mapper::look(NodeIndex at, const MovingScan& scan) {
  View view{tying_.lay(at, graph_.node(at).pose)};
  view.at_place = placeNear(session_, at)(view.laid.map_from_base);
  if (view.at_place || !graph_.node(at).looksAhead()) {
    view.agreement = newest_.agree(at, scan.first_newest);
  }
  lookForOwnSession(at, view);
  return view;
}

/// Of sonars that look ahead only places seen from the same side count: what they see from the
/// other one may look different.
std::function<bool(const Pose2d&)> Mapper::placeNear(int session, NodeIndex at) const {
  return [this, session, at](const Pose2d& pose) {
    const ScanNode& scan = graph_.node(at);
    const auto near = shelf_.nearSeen(pose, scan.seen, session, kAtPlace);
    return std::any_of(near.begin(), near.end(), [&](const PlaceShelf::Near& place) {
      const double turn = pose.yaw - graph_.node(shelf_.nodeOf(place.id)).pose.yaw;
      return !scan.looksAhead() || std::abs(wrapAngle(turn)) < kOneSide;
    });
  };
}

void Mapper::sortOut(const std::vector<Sighting>& sightings, NodeIndex at, WaySearch& ways,
                     View& view) const {
  const Pose2d& here = view.laid.map_from_base;
  const ScanNode& node = graph_.node(at);
  const bool compass =
      node.compass && std::abs(wrapAngle(*node.compass - node.pose.yaw)) < kCompassAgrees;
  for (Sighting seen : sightings) {
    const NodeIndex place = shelf_.nodeOf(seen.place);
    // Where odometry cannot tell so exactly, being back where it has the robot is a loop too.
    const std::optional<double> way = ways.to(place);
    const double sigma = std::min(
        positionSigma(way.value_or(kFarthestWay), node.compass.has_value()), mostSigma(at));
    const bool told = sigma <= kTrackSigma;
    if ((view.tracked || told) && std::hypot(seen.pose.x - here.x, seen.pose.y - here.y) < 0.5 &&
        std::abs(wrapAngle(seen.pose.yaw - here.yaw)) < 15.0 * kDegree) {
      continue;
    }
    // What no way leads to may lie anywhere.
    const double off = way ? sigmasOff(graph_, ways.along(place), compass, seen.pose) : 0.0;
    if (off > kFarthestSigmas) {
      view.beyond.push_back(seen);
      continue;
    }
    seen.prior = -0.5 * std::max(0.0, off * off - kFreeSigmas * kFreeSigmas);
    view.loops.push_back(seen);
  }
}

}  // namespace place_memory::core
