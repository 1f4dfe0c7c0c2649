#include "core/mapping/mapper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr std::chrono::nanoseconds kHeadingAge = std::chrono::seconds(1);

constexpr std::size_t kFullEvery = 20;  ///< nodes between corrections of the whole map
constexpr double kNamed = 1.2;          ///< so near is a place that a scan names [m]
constexpr double kNamedWay = 3.0;       ///< and no way farther through the graph [m]

}  // namespace

const char* nameOf(ScanDecision::Kind kind) {
  constexpr std::array<const char*, 6> kNames{"new_place", "tracked", "closed",
                                              "candidate", "between", "lost"};
  return kNames[static_cast<std::size_t>(kind)];
}

Mapper::Mapper(const MapperOptions& options)
    : options_(options),
      builder_(options.scan),
      headings_(kHeadingAge),
      shelf_(options.recognizer, SonarModel(options.sonar), options.cell_size),
      tying_(graph_, shelf_, options.sonar, options.cell_size),
      newest_(graph_, shelf_, options.sonar, options.cell_size),
      closer_(graph_, shelf_, tying_),
      loops_(options.closure),
      carried_(options.carried),
      joins_(options.join),
      belief_(PlaceBeliefOptions{}) {}

void Mapper::addHeading(std::chrono::nanoseconds stamp, double yaw) { headings_.add(stamp, yaw); }

void Mapper::addOdometry(std::chrono::nanoseconds /*stamp*/, const Pose2d& odom_from_base) {
  newest_odom_ = odom_from_base;
  reckoning_.add(odom_from_base, graph_.errors());
}

void Mapper::addReading(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base,
                        const SonarReading& reading) {
  addOdometry(stamp, odom_from_base);
  const BaseMoment moment{stamp, odom_from_base, reckoning_.pose(), reckoning_.way(),
                          reckoning_.turn()};
  continuity_.add(moment, reading, headings_.at(stamp));
  builder_.add(moment, reading);
  while (const std::optional<MovingScan> scan = builder_.take()) process(*scan);
}

void Mapper::beginSession() {
  builder_.restart();
  continuity_.restart();
  reckoning_.restart();
  headings_.clear();
  last_middle_.reset();
  told_.reset();
  is_told_ = false;
  first_of_session_ = true;
  if (!graph_.nodes().empty()) beginApart();
}

void Mapper::setMode(MapperMode mode) {
  options_.mode = mode;
  if (!graph_.nodes().empty()) map_stamp_ = graph_.nodes().back().stamp;
}

std::vector<ScanDecision> Mapper::takeDecisions() {
  std::vector<ScanDecision> taken;
  taken.swap(decisions_);
  return taken;
}

NodeIndex Mapper::append(const MovingScan& scan) {
  ScanNode node;
  node.stamp = scan.middle.stamp;
  node.odom_from_base = scan.middle.odom_from_base;
  node.first_way = scan.first_way;
  node.last_way = scan.last_way;
  node.session = session_;
  node.compass = headings_.at(node.stamp);
  node.readings = scan.readings;
  if (first_of_session_) {
    node.pose = {0.0, 0.0, node.compass.value_or(node.odom_from_base.yaw)};
    if (told_) node.pose = told_->map_from_base * told_->reckoned.inverse() * scan.middle.reckoned;
    told_.reset();
    first_of_session_ = false;
  } else {
    node.before = graph_.nodes().size() - 1;
    node.motion = graph_.nodes().back().odom_from_base.inverse() * node.odom_from_base;
    node.motion_way = scan.middle.way - last_middle_->way;
    node.motion_turn = scan.middle.turn - last_middle_->turn;
    node.pose = graph_.predicted(node);
  }
  last_middle_ = scan.middle;
  return graph_.append(node);
}

void Mapper::speakOfLoops(NodeIndex at, const MovingScan& scan, const View& view) {
  const double stretch = scan.last_way - scan.first_way;
  loops_.update(at, scan.middle.way, stretch, view.laid.map_from_base, view.loops,
                placeNear(session_, at));
  // Where it is tracked it was not carried, whatever looks like it elsewhere.
  if (view.tracked) carried_.clear();
  if (view.tracked || session_ != kMapSession) return;
  carried_.update(at, scan.middle.way, stretch, view.laid.map_from_base, view.beyond,
                  placeNear(session_, at));
}

void Mapper::speakOfJoins(NodeIndex at, const MovingScan& scan, const View& view) {
  const PlaceMatcher* map = shelf_.matcher(kMapSession);
  if (session_ == kMapSession || !map) return;
  const ScanNode& node = graph_.node(at);
  const std::vector<PlaceFit> fits =
      map->recognize(view.laid.grid, node.compass ? headingWindow() : kPi);
  believe(at, fits, view.laid);
  joins_.update(at, scan.middle.way, scan.last_way - scan.first_way, node.pose,
                tying_.sightings(fits, view.laid), placeNear(kMapSession, at));
}

void Mapper::growMap(NodeIndex at) {
  if (++scans_since_full_ >= kFullEvery && (ties_since_full_ || graph_.node(at).compass)) {
    graph_.relaxAll(session_, 3);
    if (closer_.cutContradicted()) graph_.relaxAll(session_, 10);
    afterRelaxing();
  }
  if (!standing_) undecided_.push_back(at);
  makePlaces();
}

void Mapper::process(const MovingScan& scan) {
  const NodeIndex at = append(scan);
  const double way = scan.middle.way;
  shelf_.ripen(scan.first_way, graph_);
  ScanDecision decision;
  decision.stamp = scan.middle.stamp;
  decision.spot = noticeBreak(at);
  const View view = look(at, scan);
  speakOfLoops(at, scan, view);
  if (view.tracked) {
    anchored_way_ = way;
    is_told_ = false;
    ties_since_full_ = true;
    decision.kind = ScanDecision::Kind::kTracked;
  }
  // A compass holds the heading on new ground too.
  if (view.tracked || graph_.node(at).compass) graph_.relaxRecent(kWindow);
  const bool expected = !straddlesBreak(at) && placeNear(session_, at)(graph_.node(at).pose);
  if (closer_.observe(view.tracked, expected, way)) takeBack();
  speakOfJoins(at, scan, view);
  if (accepted(carried_, kMapSession)) partWays();
  if (closeLoops(way)) {
    decision.kind = ScanDecision::Kind::kClosed;
  } else {
    judgeLost(at, view, decision);
  }
  if (options_.mode == MapperMode::kMap) growMap(at);
  if (graph_.node(at).place != kNoPlace) decision.kind = ScanDecision::Kind::kNewPlace;
  decision.lost = lost();
  name(at, view, decision);
  if (decision.place != kNoPlace) {
    decision.belief = belief_.probability(decision.place, beliefMap());
  }
  decision.reason = reasonOf(at, view, decision);
  decisions_.push_back(decision);
  if (options_.mode == MapperMode::kLocalize) tidy();
  if (options_.mode == MapperMode::kMap && scans_since_full_ == 0) thinOut();
}

void Mapper::tidy() {
  if (graph_.nodes().size() <= kWindow) return;
  ScanNode& old = graph_.node(graph_.nodes().size() - 1 - kWindow);
  if (old.place == kNoPlace && old.stamp > map_stamp_) old.readings.reset();
}

void Mapper::name(NodeIndex at, const View& view, ScanDecision& decision) const {
  const ScanNode& node = graph_.node(at);
  if (decision.kind == ScanDecision::Kind::kNewPlace) {
    decision.place = node.place;
    return;
  }
  if (session_ != kMapSession || graph_.node(at).session != kMapSession) {
    decision.kind = loops_.empty() && joins_.empty() ? ScanDecision::Kind::kLost
                                                     : ScanDecision::Kind::kCandidate;
    return;
  }
  if (view.tracked && view.agreement.disagrees) return;
  if (decision.kind == ScanDecision::Kind::kBetween && inDoubt(view)) {
    if (!loops_.empty() || !carried_.empty()) decision.kind = ScanDecision::Kind::kCandidate;
    if (lost() > 0.5) decision.kind = ScanDecision::Kind::kLost;
    return;
  }
  // From the other side the places that it is tied to are those of as far beyond what it sees.
  const double named_way = kNamedWay + 2.0 * std::hypot(node.seen.x, node.seen.y);
  WaySearch ways(graph_, at, named_way);
  for (const PlaceShelf::Near& near : shelf_.near(node.pose, session_, kNamed, true)) {
    const NodeIndex place = shelf_.nodeOf(near.id);
    if (!ways.to(place)) continue;
    decision.place = near.id;
    decision.place_from_base = graph_.node(place).pose.inverse() * node.pose;
    break;
  }
}

}  // namespace place_memory::core
