#include "core/mapping/mapper.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/grid/cell_shift.h"
#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr std::chrono::nanoseconds kHeadingAge = std::chrono::seconds(1);

constexpr std::size_t kWindow = 40;        ///< nodes that a local correction moves
constexpr std::size_t kFullEvery = 20;     ///< nodes between corrections of the whole map
constexpr double kCompassWindow = 45.0 * kDegree;
constexpr double kTieReach = 2.4;          ///< how far off the places are that a scan is tied to [m]
constexpr int kMostTies = 4;
constexpr double kTieNoise = 0.06;         // [m]
constexpr double kTieTurnNoise = 2.0 * kDegree;
constexpr double kLongUntied = 15.0;       ///< way after which the heading is anyone's guess [m]

/// The grid's content moved by whole cells.
EvidenceGrid shifted(const EvidenceGrid& grid, CellShift shift) {
  EvidenceGrid moved(grid.geometry());
  const int first = std::max(0, shift.columns);
  const int last = std::min(kGridSize, kGridSize + shift.columns);
  for (int row = std::max(0, shift.rows); row < std::min(kGridSize, kGridSize + shift.rows); ++row) {
    for (int column = first; column < last; ++column) {
      moved.add(row, column, grid.at(row - shift.rows, column - shift.columns));
    }
  }
  return moved;
}

}  // namespace

const char* nameOf(ScanDecision::Kind kind) {
  constexpr std::array<const char*, 6> kNames{"new_place", "tracked", "closed",
                                              "candidate", "between", "lost"};
  return kNames[static_cast<std::size_t>(kind)];
}

Mapper::Mapper(const MapperOptions& options)
    : options_(options),
      sonar_(options.sonar),
      builder_(options.scan),
      headings_(kHeadingAge),
      shelf_(options.recognizer, sonar_, options.cell_size),
      loops_(options.closure),
      joins_(options.closure) {}

void Mapper::addHeading(std::chrono::nanoseconds stamp, double yaw) { headings_.add(stamp, yaw); }

void Mapper::addOdometry(std::chrono::nanoseconds /*stamp*/, const Pose2d& odom_from_base) {
  newest_odom_ = odom_from_base;
  reckoning_.add(odom_from_base, graph_.errors());
}

void Mapper::addReading(std::chrono::nanoseconds stamp, const Pose2d& odom_from_base,
                        const SonarReading& reading) {
  addOdometry(stamp, odom_from_base);
  builder_.add({stamp, odom_from_base, reckoning_.pose(), reckoning_.way(), reckoning_.turn()}, reading);
  while (const std::optional<MovingScan> scan = builder_.take()) process(*scan);
}

void Mapper::beginSession() {
  builder_.restart();
  reckoning_.restart();
  headings_.clear();
  last_middle_.reset();
  first_of_session_ = true;
  undecided_.clear();
  loops_.clear();
  joins_ = ClosureCandidates(options_.mode == MapperMode::kMap ? options_.closure
                                                               : options_.relocate);
  if (!graph_.nodes().empty()) session_ = ++last_session_;
  lost_ = graph_.nodes().empty() ? 0.0 : 1.0;
}

std::vector<ScanDecision> Mapper::takeDecisions() {
  std::vector<ScanDecision> taken;
  taken.swap(decisions_);
  return taken;
}

std::optional<Pose2d> Mapper::mapFromOdom() const {
  if (session_ != 1 || !last_middle_) return std::nullopt;
  const Pose2d map_from_base =
      graph_.nodes().back().pose * (last_middle_->reckoned.inverse() * reckoning_.pose());
  return map_from_base * newest_odom_.inverse();
}

std::vector<MappedPlace> Mapper::places() const {
  std::vector<MappedPlace> places;
  for (const auto& [id, at] : shelf_.places()) {
    const ScanNode& node = graph_.node(at);
    places.push_back({id, "place_" + std::to_string(id), node.stamp, node.pose,
                      node.session != 1});
  }
  return places;
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
  if (graph_.nodes().back().compass) return kCompassWindow;
  return reckoning_.way() - anchored_way_ > kLongUntied ? kPi : kCompassWindow;
}

EvidenceGrid Mapper::lay(const ScanNode& node, double yaw) const {
  return sonar_.build(movedReadings(*node.readings, {0.0, 0.0, yaw}), {options_.cell_size});
}

Pose2d Mapper::poseBy(const PlaceFit& fit, double scan_yaw) const {
  const ScanNode& place = graph_.node(shelf_.nodeOf(fit.id));
  return place.pose * Pose2d{0.0, 0.0, -place.laid_yaw} * fit.place_from_scan *
         Pose2d{0.0, 0.0, scan_yaw};
}

std::vector<Sighting> Mapper::sightings(const std::vector<PlaceFit>& fits, double scan_yaw) const {
  std::vector<Sighting> seen;
  for (const PlaceFit& fit : fits) {
    seen.push_back({fit.id, fit.probability, poseBy(fit, scan_yaw)});
  }
  return seen;
}

bool Mapper::tieTo(PlaceId id, NodeIndex node, const LaidScan& scan, double near, double window,
                   int closure) {
  const NodeIndex at = shelf_.nodeOf(id);
  const ScanNode& place = graph_.node(at);
  const Pose2d base_from_grid{0.0, 0.0, -place.laid_yaw};
  const Pose2d grid_from_base{0.0, 0.0, scan.map_from_base.yaw};
  const Pose2d expected =
      (place.pose * base_from_grid).inverse() * scan.map_from_base * grid_from_base.inverse();
  // Moved by whole cells to about the place's middle, within the reach of the search; what is left
  // of the distance is for the alignment to tell.
  const double cell = options_.cell_size;
  const CellShift shift{static_cast<int>(std::lround(expected.x / cell)),
                        static_cast<int>(std::lround(expected.y / cell))};
  const Pose2d moved{shift.columns * cell, shift.rows * cell, 0.0};
  const PlaceFit fit = shelf_.matcher(session_)->align(shifted(scan.grid, shift), id, window);
  const Pose2d found = fit.place_from_scan * moved;
  if (std::hypot(found.x - expected.x, found.y - expected.y) > near) return false;
  if (std::abs(wrapAngle(found.yaw - expected.yaw)) > 10.0 * kDegree) return false;
  // The alignment turns about the place, the robot stands aside.
  Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
  lever(0, 2) = -(found.y - fit.place_from_scan.y);
  lever(1, 2) = found.x - fit.place_from_scan.x;
  // What both grids owe to noise, beside what the alignment shows.
  Eigen::Matrix3d covariance = fit.covariance;
  covariance.diagonal() += Eigen::Vector3d(kTieNoise * kTieNoise, kTieNoise * kTieNoise,
                                           kTieTurnNoise * kTieTurnNoise);
  covariance = lever * covariance * lever.transpose();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const double c = std::cos(base_from_grid.yaw), s = std::sin(base_from_grid.yaw);
  turn.topLeftCorner<2, 2>() << c, -s, s, c;
  covariance = turn * covariance * turn.transpose();
  graph_.tie({at, node, base_from_grid * found * grid_from_base, covariance.inverse(), closure});
  return true;
}

bool Mapper::track(NodeIndex at, const LaidScan& scan, const std::vector<PlaceFit>& fits) {
  const Pose2d estimate = scan.map_from_base;
  const bool compass = graph_.node(at).compass.has_value();
  const auto ways = graph_.ways(at, 80.0);
  const auto sigmaTo = [&](PlaceId id) {
    const auto way = ways.find(shelf_.nodeOf(id));
    return positionSigma(way == ways.end() ? 80.0 : way->second, compass);
  };
  bool tracked = false;
  for (const PlaceFit& fit : fits) {
    const Pose2d pose = poseBy(fit, estimate.yaw);
    const double off = std::hypot(pose.x - estimate.x, pose.y - estimate.y);
    const double turn = std::abs(wrapAngle(pose.yaw - estimate.yaw));
    const bool close = off <= 0.5 && turn <= 8.0 * kDegree && fit.probability >= 0.3;
    const bool sure = off <= 1.0 && turn <= 15.0 * kDegree && fit.probability >= 0.82;
    if (!(close || sure) || off > 0.3 + 3.0 * sigmaTo(fit.id)) continue;
    tracked = true;
    break;
  }
  if (!tracked) return false;
  int ties = 0;
  for (const PlaceShelf::Near& near : shelf_.near(estimate, session_, kTieReach, true, graph_)) {
    if (ties == kMostTies) break;
    const double reach = std::min(1.0, 0.3 + 3.0 * sigmaTo(near.id));
    ties += tieTo(near.id, at, scan, reach, 15.0 * kDegree, 0) ? 1 : 0;
  }
  return ties > 0;
}

void Mapper::process(const MovingScan& scan) {
  const NodeIndex at = append(scan);
  shelf_.ripen(scan.first_way, graph_);
  ScanDecision decision;
  decision.stamp = scan.middle.stamp;
  const double yaw = graph_.node(at).pose.yaw;
  const EvidenceGrid grid = lay(graph_.node(at), yaw);
  const auto nearPlace = [&](int session) {
    return [this, session](const Pose2d& pose) {
      return !shelf_.near(pose, session, 0.6, true, graph_).empty();
    };
  };

  bool tracked = false;
  if (const PlaceMatcher* own = shelf_.matcher(session_)) {
    const std::vector<PlaceFit> fits = own->recognize(grid, headingWindow());
    tracked = track(at, {grid, graph_.node(at).pose}, fits);
    std::vector<Sighting> elsewhere = sightings(fits, yaw);
    const Pose2d estimate = graph_.node(at).pose;
    elsewhere.erase(std::remove_if(elsewhere.begin(), elsewhere.end(),
                                   [&](const Sighting& seen) {
                                     return std::hypot(seen.pose.x - estimate.x,
                                                       seen.pose.y - estimate.y) < 0.5 &&
                                            std::abs(wrapAngle(seen.pose.yaw - estimate.yaw)) <
                                                15.0 * kDegree;
                                   }),
                    elsewhere.end());
    loops_.update(at, scan.middle.way, estimate, elsewhere, nearPlace(session_));
  }
  if (tracked) {
    anchored_way_ = scan.middle.way;
    ties_since_full_ = true;
    decision.kind = ScanDecision::Kind::kTracked;
  }
  // A compass holds the heading on new ground too.
  if (tracked || graph_.node(at).compass) graph_.relaxRecent(kWindow);
  bool closed = false;
  if (const ClosureCandidate* loop = loops_.accepted()) closed = closeLoop(*loop, session_);
  if (!closed && session_ != 1) {
    if (const PlaceMatcher* map = shelf_.matcher(1)) {
      const double window = graph_.node(at).compass ? kCompassWindow : kPi;
      joins_.update(at, scan.middle.way, graph_.node(at).pose,
                    sightings(map->recognize(grid, window), yaw), nearPlace(1));
      if (const ClosureCandidate* join = joins_.accepted()) closed = closeLoop(*join, 1);
    }
  }
  if (closed) {
    anchored_way_ = scan.middle.way;
    decision.kind = ScanDecision::Kind::kClosed;
  }
  if (options_.mode == MapperMode::kMap) {
    if (++scans_since_full_ >= kFullEvery && (ties_since_full_ || graph_.node(at).compass)) {
      graph_.relaxAll(session_, 3);
      afterRelaxing();
    }
    undecided_.push_back(at);
    makePlaces();
    if (graph_.node(at).place != kNoPlace) decision.kind = ScanDecision::Kind::kNewPlace;
  }
  name(at, decision);
  decisions_.push_back(decision);
}

void Mapper::afterRelaxing() {
  scans_since_full_ = 0;
  ties_since_full_ = false;
  // Of places that have come to lie on each other the newer one goes; its scan stays in the graph.
  std::vector<PlaceId> doubled;
  for (const auto& [id, at] : shelf_.places()) {
    const ScanNode& node = graph_.node(at);
    for (const PlaceShelf::Near& near :
         shelf_.near(node.pose, node.session, options_.doubled, false, graph_)) {
      if (near.id < id) {
        doubled.push_back(id);
        break;
      }
    }
  }
  for (const PlaceId id : doubled) shelf_.remove(id, graph_);
  shelf_.follow(graph_);
}

bool Mapper::closeLoop(const ClosureCandidate& candidate, int target) {
  const ClosureCandidate closure = candidate;
  const bool joins = target != session_;
  const int before = session_;
  const int number = ++closures_;
  std::vector<Pose2d> poses;
  for (const ScanNode& node : graph_.nodes()) poses.push_back(node.pose);
  double old_chi = 0.0;
  for (const Tie& tie : graph_.ties()) old_chi += std::min(graph_.chiSquare(tie), 25.0);

  if (joins) {
    graph_.join(session_, target, closure.target_from_estimate);
    shelf_.join(session_, target);
    session_ = target;
  }
  for (const Witness& witness : closure.witnesses) {
    const Pose2d kept = graph_.node(witness.node).pose;
    const Pose2d there = joins ? kept : closure.target_from_estimate * kept;
    if (shelf_.has(witness.place)) {
      tieTo(witness.place, witness.node, {lay(graph_.node(witness.node), there.yaw), there}, 0.7,
            20.0 * kDegree, number);
    }
  }
  if (options_.mode == MapperMode::kMap) {
    graph_.relaxAll(session_, 15);
    double new_chi = 0.0;
    int fresh = 0, outvoted = 0;
    for (const Tie& tie : graph_.ties()) {
      const double chi = graph_.chiSquare(tie);
      if (tie.closure == number) {
        ++fresh;
        outvoted += chi > 16.0 ? 1 : 0;
      } else {
        new_chi += std::min(chi, 25.0);
      }
    }
    if (!joins && (new_chi > old_chi + 25.0 || 3 * outvoted > fresh)) {
      graph_.untie([&](const Tie& tie) { return tie.closure == number; });
      for (std::size_t i = 0; i < poses.size(); ++i) graph_.node(i).pose = poses[i];
      loops_.dropForemost();
      return false;
    }
    afterRelaxing();
  } else {
    graph_.relaxRecent(kWindow);
  }
  (void)before;
  loops_.clear();
  joins_.clear();
  lost_ = 0.0;
  return true;
}

void Mapper::makePlaces() {
  const auto pending = [](const ClosureCandidates& candidates) {
    const ClosureCandidate* best = candidates.foremost();
    return best && best->witnesses.size() >= 2;
  };
  if (pending(loops_) || pending(joins_)) return;
  for (const NodeIndex at : undecided_) {
    const ScanNode& node = graph_.node(at);
    if (shelf_.near(node.pose, node.session, options_.spacing, false, graph_).empty()) {
      shelf_.add(at, graph_);
    }
  }
  undecided_.clear();
}

void Mapper::name(NodeIndex at, ScanDecision& decision) const {
  const ScanNode& node = graph_.node(at);
  if (decision.kind == ScanDecision::Kind::kNewPlace) {
    decision.place = node.place;
    return;
  }
  if (session_ != 1) {
    decision.kind = loops_.empty() && joins_.empty() ? ScanDecision::Kind::kLost
                                                     : ScanDecision::Kind::kCandidate;
    return;
  }
  const auto ways = graph_.ways(at, 3.0);
  for (const PlaceShelf::Near& near : shelf_.near(node.pose, session_, 1.2, true, graph_)) {
    const NodeIndex place = shelf_.nodeOf(near.id);
    if (ways.find(place) == ways.end()) continue;
    decision.place = near.id;
    decision.place_from_base = graph_.node(place).pose.inverse() * node.pose;
    break;
  }
}

}  // namespace place_memory::core
