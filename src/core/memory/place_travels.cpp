#include "core/memory/place_travels.h"

#include <cmath>
#include <optional>

namespace place_memory::core {
namespace {

constexpr double kAtPlace = 1.2;  ///< so near to a place the robot is at it [m]

/// At which place a scan was taken.
struct Visit {
  PlaceId place = kNoPlace;
  Pose2d place_from_base;
  double off = kAtPlace;  ///< of the place [m]
};

std::vector<Visit> visitsOf(const KeptMap& drive) {
  std::vector<Visit> visits(drive.nodes.size());
  for (const Tie& tie : drive.ties) {
    const PlaceId place = drive.nodes[tie.place].place;
    const double off = std::hypot(tie.relative.x, tie.relative.y);
    Visit& visit = visits[tie.node];
    if (place == kNoPlace || off >= visit.off) continue;
    visit = {place, tie.relative, off};
  }
  for (NodeIndex at = 0; at < drive.nodes.size(); ++at) {
    if (drive.nodes[at].place != kNoPlace) visits[at] = {drive.nodes[at].place, Pose2d{}, 0.0};
  }
  return visits;
}

/// The newest visit up to a node, and the way since then.
struct Departure {
  Visit visit;
  std::chrono::nanoseconds stamp{0};
  Pose2d motion;
};

}  // namespace

std::vector<PlaceTravel> travelsOf(const KeptMap& drive) {
  const std::vector<Visit> visits = visitsOf(drive);
  std::vector<std::optional<Departure>> departures(drive.nodes.size());
  std::vector<PlaceTravel> travels;
  // A node comes after the one before it.
  for (NodeIndex at = 0; at < drive.nodes.size(); ++at) {
    const ScanNode& node = drive.nodes[at];
    std::optional<Departure> from;
    if (node.before) from = departures[*node.before];
    if (from) from->motion = from->motion * node.motion;
    const Visit& here = visits[at];
    if (here.place == kNoPlace) {
      departures[at] = from;
      continue;
    }
    departures[at] = Departure{here, node.stamp, Pose2d{}};
    if (!from || from->visit.place == here.place) continue;
    travels.push_back({from->visit.place, here.place, from->visit.place_from_base,
                       here.place_from_base, from->motion, from->stamp, node.stamp});
  }
  return travels;
}

}  // namespace place_memory::core
