#include "core/mapping/mapper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr std::chrono::nanoseconds kHeadingAge = std::chrono::seconds(1);

constexpr std::size_t kFullEvery = 20;  ///< nodes between corrections of the whole map
constexpr double kAtPlace = 0.6;        ///< so near to a place a scan should show it [m]
constexpr double kCompassWindow = 45.0 * kDegree;
constexpr double kCompassAgrees = 30.0 * kDegree;
constexpr double kUseful = 0.3;      ///< probability of a match that is worth something
constexpr double kLongUntied = 5.0;  ///< way after which the heading is anyone's guess [m]

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
      closer_(graph_, shelf_, tying_),
      loops_(options.closure),
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
  builder_.add({stamp, odom_from_base, reckoning_.pose(), reckoning_.way(), reckoning_.turn()},
               reading);
  while (const std::optional<MovingScan> scan = builder_.take()) process(*scan);
}

void Mapper::beginSession() {
  builder_.restart();
  reckoning_.restart();
  headings_.clear();
  last_middle_.reset();
  told_.reset();
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

double Mapper::headingWindow() const {
  const ScanNode& node = graph_.nodes().back();
  if (!node.compass) return kCompassWindow;
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

void Mapper::process(const MovingScan& scan) {
  const NodeIndex at = append(scan);
  const double way = scan.middle.way;
  const double stretch = scan.last_way - scan.first_way;
  shelf_.ripen(scan.first_way, graph_);
  ScanDecision decision;
  decision.stamp = scan.middle.stamp;
  const LaidScan laid = tying_.lay(at, graph_.node(at).pose);

  bool tracked = false;
  std::vector<Sighting> others;
  if (const PlaceMatcher* own = shelf_.matcher(session_)) {
    const std::vector<PlaceFit> fits = own->recognize(laid.grid, headingWindow());
    if (session_ == kMapSession) believe(at, fits, laid);
    tracked = tying_.track(at, laid, fits, closer_.onTrial());
    others =
        elsewhere(tying_.sightings(tracked ? fits : recognizeAnyhow(*own, laid, fits), laid), laid);
    loops_.update(at, way, stretch, laid.map_from_base, others, placeNear(session_));
  }
  if (tracked) {
    anchored_way_ = way;
    refused_ = 0;
    ties_since_full_ = true;
    decision.kind = ScanDecision::Kind::kTracked;
  }
  // A compass holds the heading on new ground too.
  if (tracked || graph_.node(at).compass) graph_.relaxRecent(kWindow);
  if (closer_.observe(tracked, placeNear(session_)(graph_.node(at).pose), way)) takeBack();
  if (session_ != kMapSession) {
    if (const PlaceMatcher* map = shelf_.matcher(kMapSession)) {
      const std::vector<PlaceFit> fits =
          map->recognize(laid.grid, graph_.node(at).compass ? headingWindow() : kPi);
      believe(at, fits, laid);
      joins_.update(at, way, stretch, graph_.node(at).pose, tying_.sightings(fits, laid),
                    placeNear(kMapSession));
    }
  }
  if (closeLoops(way)) {
    anchored_way_ = way;
    decision.kind = ScanDecision::Kind::kClosed;
  }
  if (options_.mode == MapperMode::kMap) {
    if (++scans_since_full_ >= kFullEvery && (ties_since_full_ || graph_.node(at).compass)) {
      graph_.relaxAll(session_, 3);
      if (closer_.cutContradicted()) graph_.relaxAll(session_, 10);
      afterRelaxing();
    }
    if (!standing_) undecided_.push_back(at);
    makePlaces();
    if (graph_.node(at).place != kNoPlace) decision.kind = ScanDecision::Kind::kNewPlace;
  }
  judgeLost(at, tracked, others);
  decision.lost = lost();
  name(at, decision);
  if (decision.place != kNoPlace) {
    decision.belief = belief_.probability(decision.place, beliefMap());
  }
  decisions_.push_back(decision);
  if (options_.mode == MapperMode::kLocalize) tidy();
  if (options_.mode == MapperMode::kMap && scans_since_full_ == 0) thinOut();
}

void Mapper::tidy() {
  if (graph_.nodes().size() <= kWindow) return;
  ScanNode& old = graph_.node(graph_.nodes().size() - 1 - kWindow);
  if (old.place == kNoPlace && old.stamp > map_stamp_) old.readings.reset();
}

std::function<bool(const Pose2d&)> Mapper::placeNear(int session) const {
  return [this, session](const Pose2d& pose) {
    return !shelf_.near(pose, session, kAtPlace, true).empty();
  };
}

std::vector<Sighting> Mapper::elsewhere(std::vector<Sighting> sightings,
                                        const LaidScan& scan) const {
  const Pose2d& here = scan.map_from_base;
  const auto is_here = [&](const Sighting& seen) {
    return std::hypot(seen.pose.x - here.x, seen.pose.y - here.y) < 0.5 &&
           std::abs(wrapAngle(seen.pose.yaw - here.yaw)) < 15.0 * kDegree;
  };
  sightings.erase(std::remove_if(sightings.begin(), sightings.end(), is_here), sightings.end());
  return sightings;
}

void Mapper::name(NodeIndex at, ScanDecision& decision) const {
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
  const auto ways = graph_.ways(at, 3.0);
  for (const PlaceShelf::Near& near : shelf_.near(node.pose, session_, 1.2, true)) {
    const NodeIndex place = shelf_.nodeOf(near.id);
    if (ways.find(place) == ways.end()) continue;
    decision.place = near.id;
    decision.place_from_base = graph_.node(place).pose.inverse() * node.pose;
    break;
  }
}

}  // namespace place_memory::core
