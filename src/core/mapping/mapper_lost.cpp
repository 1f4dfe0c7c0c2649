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
constexpr double kDeviates = 0.45;     ///< of the compass, so that any heading is looked at [rad]
constexpr double kLost = 0.5;          ///< P(lost) at which a robot that was carried starts anew
constexpr double kDoubtful = 0.2;      ///< P(lost) from which no place is named
constexpr double kNoDoubt = 0.01;      ///< P(lost) of a robot that was tracked a scan ago
constexpr double kJustTied = 2.1;      ///< way since the middle of a scan that was tracked [m]
constexpr NodeIndex kNodesBefore = 8;  ///< a scan's stretch and more
constexpr NodeIndex kLongPart = 16;    ///< that is a way of its own
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
  believed_odom_ = node.odom_from_base;
  seen_ = std::make_shared<const EvidenceGrid>(scan.grid);
  seen_from_base_ = scan.grid_from_base;
}

BeliefSummary Mapper::belief() const {
  BeliefSummary summary;
  for (const auto& [id, state] : belief_.states()) {
    if (!shelf_.has(id)) continue;
    const Pose2d& map_from_place = graph_.node(shelf_.nodeOf(id)).pose;
    summary.places.push_back({id, state.mass, map_from_place * state.place_from_base});
  }
  std::sort(summary.places.begin(), summary.places.end(),
            [](const BelievedPlace& a, const BelievedPlace& b) {
              return a.probability != b.probability ? a.probability > b.probability : a.id < b.id;
            });
  if (summary.places.size() > kMostTold) summary.places.resize(kMostTold);
  summary.off_map = belief_.offMap();
  summary.lost = lost();
  summary.odom_from_base = believed_odom_;
  summary.seen = seen_;
  summary.seen_from_base = seen_from_base_;
  return summary;
}

bool Mapper::straddlesBreak(NodeIndex at) const {
  return break_way_ && graph_.node(at).first_way < *break_way_;
}

ScanWitness Mapper::witnessOf(NodeIndex at, const View& view) const {
  if (view.tracked) return ScanWitness::kAgrees;
  // Of a session apart it is known only whether the robot is still in it.
  if (session_ != kMapSession) return ScanWitness::kSilent;
  const ClosureCandidate* carried = carried_.foremost();
  const bool again = carried && carried->witnesses.size() >= 2 &&
                     carried->witnesses.back().node + 1 == graph_.nodes().size();
  const bool sure = !view.beyond.empty() && view.beyond.front().probability >= kSurelyElsewhere;
  const bool disagrees = view.agreement.disagrees;
  if (again || sure) {
    return view.at_place || disagrees ? ScanWitness::kElsewhere : ScanWitness::kDoubts;
  }
  // After a long way, and where scans agree on a loop that odometry allows, that is what it is.
  const double untied = reckoning_.way() - anchored_way_;
  const ClosureCandidate* loop = loops_.foremost();
  const bool closes = loop && loop->witnesses.size() >= 2;
  if (closes || straddlesBreak(at) || untied >= kSurelyAnchored || graph_.ties().empty())
    return ScanWitness::kSilent;
  if (disagrees) return ScanWitness::kContradicts;
  return view.at_place ? ScanWitness::kMisses : ScanWitness::kSilent;
}

Spot Mapper::noticeBreak(NodeIndex at) {
  const Spot spot = continuity_.take();
  const ScanNode& node = graph_.node(at);
  if (!node.before) return spot;
  const double carried = lost_.drive(spot, node.last_way - graph_.node(*node.before).last_way);
  if (carried > kDoubtful) break_way_ = spot.way;
  return spot;
}

void Mapper::judgeLost(NodeIndex at, const View& view, ScanDecision& decision) {
  const ScanNode& node = graph_.node(at);
  if (!node.before || session_ != node.session) return;
  decision.witness = witnessOf(at, view);
  lost_.see(decision.witness);
  if (lost_.probability() < kDoubtful) break_way_.reset();
  const bool here =
      decision.witness != ScanWitness::kSilent && decision.witness != ScanWitness::kDoubts;
  const bool broke = break_way_ && node.first_way >= *break_way_ && !view.tracked;
  if (lost_.probability() > (broke ? kLost : here ? kSurelyLost : 1.0)) partWays();
}

bool Mapper::inDoubt(const View& view) const {
  // Where nothing speaks against it, little that is seen does not either.
  const double unseen = lost_.probability() < kNoDoubt ? 1.0 : 0.0;
  const bool agrees = view.agreement.newest.value_or(unseen) >= kAgrees;
  const ScanNode& node = graph_.nodes().back();
  const double middle = 0.5 * (node.first_way + node.last_way);
  const bool just_tied = middle - anchored_way_ <= kJustTied;
  return lost_.probability() > kDoubtful || !agrees || !just_tied;
}

/// Of the nodes that odometry leads to from here, the first after the break; where there is none,
/// the first after the last tie.
NodeIndex Mapper::firstAstray() const {
  NodeIndex first = graph_.nodes().size() - 1;
  const auto is_astray = [this](NodeIndex at) {
    const double middle = 0.5 * (graph_.node(at).first_way + graph_.node(at).last_way);
    return break_way_ ? middle > *break_way_ : !graph_.tied(at);
  };
  while (graph_.node(first).before && is_astray(*graph_.node(first).before)) {
    first = *graph_.node(first).before;
  }
  return first;
}

/// What was driven since it was carried lies nobody knows where. Where nothing shows when that was,
/// it is what was driven since the last tie; but of a long way most was driven before the first
/// scan that was known elsewhere, and is apart from what came after it.
void Mapper::partWays() {
  note(MapperEvent::Kind::kLost);
  const NodeIndex first = firstAstray();
  NodeIndex cut = first;
  const bool whole_map = first == 0;
  const ClosureCandidate* carried = carried_.foremost();
  const NodeIndex seen = carried ? carried->witnesses.front().node : 0;
  const bool is_long = seen > first + kNodesBefore + (whole_map ? 0 : kLongPart);
  if (!break_way_ && is_long) cut = seen - kNodesBefore;
  if (cut == 0) {  // there would be no map left
    carried_.clear();
    if (break_way_) lost_.set(0.0);
    break_way_.reset();
    return;
  }
  // A place may be made of readings from before and after.
  NodeIndex mixed = cut;
  while (break_way_ && graph_.node(mixed).before &&
         graph_.node(*graph_.node(mixed).before).last_way > *break_way_) {
    mixed = *graph_.node(mixed).before;
  }
  for (NodeIndex at = mixed; at < graph_.nodes().size(); ++at) {
    if (graph_.node(at).place != kNoPlace) shelf_.remove(graph_.node(at).place, graph_);
  }
  if (cut != first && !whole_map) {
    graph_.cutBefore(first);
    graph_.split(first, ++last_session_, Pose2d{});
  }
  graph_.cutBefore(cut);
  ClosureCandidates known = carried_;
  beginApart();
  if (options_.mode == MapperMode::kMap) joins_ = ClosureCandidates(options_.rejoin);
  joins_.takeOver(known);
  graph_.split(cut, session_, Pose2d{});
  shelf_.resort(graph_);
}

void Mapper::beginApart() {
  undecided_.clear();
  loops_.clear();
  carried_.clear();
  joins_ = ClosureCandidates(options_.mode == MapperMode::kMap ? options_.join : options_.relocate);
  closer_.endTrial();
  std::size_t known = 0;
  compass_guides_ =
      std::all_of(shelf_.places().begin(), shelf_.places().end(), [&](const auto& place) {
        const std::optional<double> deviation = graph_.compassDeviation(place.second);
        known += deviation ? 1 : 0;
        return !deviation || std::abs(*deviation) < kDeviates;
      });
  compass_guides_ = compass_guides_ && known > 0;
  session_ = ++last_session_;
  lost_.set(0.0);
  break_way_.reset();
  belief_.reset();
  seen_.reset();
}

}  // namespace place_memory::core
