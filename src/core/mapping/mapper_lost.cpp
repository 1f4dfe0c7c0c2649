// Whether the robot is where it thinks, and what becomes of it where it is not.
#include <algorithm>
#include <cmath>

#include "core/mapping/mapper.h"

namespace place_memory::core {
namespace {

/// Further from its last tie a robot may not expect to see what is near where it thinks it is [m].
constexpr double kSurelyAnchored = 12.0;
constexpr double kSurelyElsewhere = 0.82;  ///< probability of another place
constexpr double kSurelyLost = 0.98;
constexpr double kFarthestWay = 60.0;  ///< ways through the graph that are followed [m]
constexpr std::size_t kMostTold = 32;  ///< places of a belief

}  // namespace

PlaceBelief::Map Mapper::beliefMap() const {
  PlaceBelief::Map map;
  const PlaceMatcher* matcher = shelf_.matcher(kMapSession);
  map.places = matcher ? matcher->size() : 0;
  map.map_from_place = [this](PlaceId id) { return graph_.node(shelf_.nodeOf(id)).pose; };
  const bool compass = !graph_.nodes().empty() && graph_.nodes().back().compass.has_value();
  map.sigma = [compass](double way) { return positionSigma(way, compass); };
  map.near = [this](const Pose2d& pose, double radius) {
    return shelf_.near(pose, kMapSession, radius, true);
  };
  return map;
}

void Mapper::believe(NodeIndex at, const std::vector<PlaceFit>& fits, const LaidScan& scan) {
  const ScanNode& node = graph_.node(at);
  const double stretch = std::max(node.last_way - node.first_way, 1e-3);
  const double moved = node.before ? node.last_way - graph_.node(*node.before).last_way : stretch;
  const PlaceBelief::Map map = beliefMap();
  if (node.before) {
    belief_.predict({graph_.node(*node.before).pose.inverse() * scan.map_from_base, node.motion_way,
                     std::min(1.0, moved)},
                    map);
  }
  std::vector<BeliefMatch> matches;
  double known = 0.0;
  const std::vector<Sighting> seen = tying_.sightings(fits, scan);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    known += fits[i].probability;
    matches.push_back(
        {fits[i].id, fits[i].score, map.map_from_place(fits[i].id).inverse() * seen[i].pose});
  }
  belief_.measure(matches, known, std::min(1.0, moved), map);
}

BeliefSummary Mapper::belief() const {
  BeliefSummary summary;
  for (const auto& [id, state] : belief_.states()) summary.places.emplace_back(id, state.mass);
  std::sort(summary.places.begin(), summary.places.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  if (summary.places.size() > kMostTold) summary.places.resize(kMostTold);
  summary.off_map = belief_.offMap();
  summary.lost = lost();
  return summary;
}

bool Mapper::outOfReach(NodeIndex at, PlaceId place, const Pose2d& pose) const {
  if (!shelf_.has(place)) return false;
  const ScanNode& node = graph_.node(at);
  const auto ways = graph_.ways(at, kFarthestWay);
  const auto way = ways.find(shelf_.nodeOf(place));
  if (way == ways.end()) return false;  // a loop that is not closed may lie anywhere
  return std::hypot(pose.x - node.pose.x, pose.y - node.pose.y) >
         1.0 + 4.0 * positionSigma(way->second, node.compass.has_value());
}

void Mapper::judgeLost(NodeIndex at, bool tracked, const std::vector<Sighting>& others) {
  const ScanNode& node = graph_.node(at);
  if (!node.before || session_ != kMapSession) return;
  const double untied = reckoning_.way() - anchored_way_;
  const ClosureCandidate* loop = loops_.foremost();
  ScanWitness witness = ScanWitness::kSilent;
  if (tracked) {
    witness = ScanWitness::kAgrees;
  } else if (untied >= kSurelyAnchored || graph_.ties().empty()) {
    witness = ScanWitness::kSilent;  // that the robot is elsewhere would be a loop to close
  } else if ((!others.empty() && others.front().probability >= kSurelyElsewhere &&
              outOfReach(at, others.front().place, others.front().pose)) ||
             (loop && loop->witnesses.size() >= 2 && loop->witnesses.back().node == at &&
              outOfReach(at, loop->witnesses.back().place,
                         loop->target_from_estimate * node.pose))) {
    witness = placeNear(session_)(node.pose) ? ScanWitness::kElsewhere : ScanWitness::kDoubts;
  } else if (placeNear(session_)(node.pose)) {
    witness = ScanWitness::kMisses;
  }
  lost_.update(witness, node.last_way - graph_.node(*node.before).last_way);
  if (lost_.probability() > kSurelyLost) partWays();
}

void Mapper::partWays() {
  // What was driven since the last tie lies nobody knows where.
  NodeIndex first = graph_.nodes().size() - 1;
  while (first > 0 && graph_.node(first).before && !graph_.tied(*graph_.node(first).before)) {
    --first;
  }
  // A place among it may be made of readings from before and after.
  for (NodeIndex at = first; at < graph_.nodes().size(); ++at) {
    if (graph_.node(at).place != kNoPlace) shelf_.remove(graph_.node(at).place, graph_);
  }
  graph_.cutBefore(first);
  beginApart();
  graph_.split(first, session_, Pose2d{});
  shelf_.resort(graph_);
}

void Mapper::beginApart() {
  undecided_.clear();
  loops_.clear();
  joins_ = ClosureCandidates(options_.mode == MapperMode::kMap ? options_.join : options_.relocate);
  closer_.endTrial();
  session_ = ++last_session_;
  lost_.set(0.0);
  belief_.reset();
}

}  // namespace place_memory::core
