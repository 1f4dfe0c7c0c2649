#include "core/mapping/scan_graph.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "core/mapping/seen_middle.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
// Of odometry, once its lasting errors are taken out, by the root of the way [m].
constexpr double kPositionNoise = 0.03;      // [m]
constexpr double kYawNoise = 1.5 * kDegree;  // [rad]
constexpr double kTurnNoise = 0.03;          // of a turn
constexpr double kCompassSigma = 30.0 * kDegree;
/// Ties of neighbouring scans err together, since those share readings.
constexpr double kTieDoubt = 2.0;
constexpr double kAgreed = 9.0;   ///< chi square up to which a tie is a way
constexpr double kTieWay = 0.1;   // [m]
constexpr double kAtPlace = 1.0;  ///< a scan's compass is that of the place [m]

Eigen::Matrix3d motionInformation(double way, double turn) {
  const double root = std::sqrt(std::max(way, 0.05));
  const double position = kPositionNoise * root + 0.002;
  const double yaw = kYawNoise * root + kTurnNoise * std::abs(turn);
  return Eigen::Vector3d(1.0 / (position * position), 1.0 / (position * position),
                         1.0 / (yaw * yaw))
      .asDiagonal();
}

}  // namespace

double yawSigma(double way) { return 2.0 * kDegree * std::sqrt(way); }

double positionSigma(double way, bool compass) {
  const double along = kPositionNoise * std::sqrt(way);
  const double turned = yawSigma(way) * way / std::sqrt(3.0);
  return along + (compass ? std::min(turned, 0.3 * std::sqrt(way)) : turned);
}

NodeIndex ScanGraph::append(ScanNode node) {
  node.seen = node.readings ? seenMiddle(*node.readings) : Pose2d{};
  nodes_.push_back(std::move(node));
  ties_of_.emplace_back();
  next_of_.emplace_back();
  const std::optional<NodeIndex>& before = nodes_.back().before;
  if (before) next_of_[*before].push_back(nodes_.size() - 1);
  return nodes_.size() - 1;
}

void ScanGraph::assign(std::vector<ScanNode> nodes, std::vector<Tie> ties,
                       const OdometryErrors& errors) {
  nodes_ = std::move(nodes);
  ties_ = std::move(ties);
  errors_ = errors;
  ties_of_.assign(nodes_.size(), {});
  next_of_.assign(nodes_.size(), {});
  for (NodeIndex at = 0; at < nodes_.size(); ++at) {
    if (nodes_[at].readings) nodes_[at].seen = seenMiddle(*nodes_[at].readings);
    if (nodes_[at].before) next_of_[*nodes_[at].before].push_back(at);
  }
  indexTies();
}

Pose2d ScanGraph::predicted(const ScanNode& node) const {
  return nodes_[*node.before].pose *
         errors_.corrected(node.motion, node.motion_way, node.motion_turn);
}

void ScanGraph::tie(const Tie& tie) {
  ties_of_[tie.place].push_back(ties_.size());
  ties_of_[tie.node].push_back(ties_.size());
  ties_.push_back(tie);
}

void ScanGraph::indexTies() {
  for (auto& ties : ties_of_) ties.clear();
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    ties_of_[ties_[i].place].push_back(i);
    ties_of_[ties_[i].node].push_back(i);
  }
}

double ScanGraph::chiSquare(const Tie& tie) const {
  const Pose2d off =
      tie.relative.inverse() * (nodes_[tie.place].pose.inverse() * nodes_[tie.node].pose);
  const Pose2d turned = Pose2d{0.0, 0.0, tie.relative.yaw} * Pose2d{off.x, off.y, 0.0};
  const Eigen::Vector3d error(turned.x, turned.y, off.yaw);
  return error.dot(tie.information * error);
}

std::optional<double> ScanGraph::compassDeviation(NodeIndex place) const {
  double x = 0.0, y = 0.0;
  const auto add = [&](const ScanNode& node) {
    if (!node.compass) return;
    const double deviation = *node.compass - node.pose.yaw;
    x += std::cos(deviation);
    y += std::sin(deviation);
  };
  add(nodes_[place]);
  for (const std::size_t i : ties_of_[place]) {
    const Tie& tie = ties_[i];
    if (tie.place == place && std::hypot(tie.relative.x, tie.relative.y) < kAtPlace) {
      add(nodes_[tie.node]);
    }
  }
  if (x == 0.0 && y == 0.0) return std::nullopt;
  return std::atan2(y, x);
}

void ScanGraph::steps(NodeIndex from, std::vector<Step>& found) const {
  found.clear();
  if (nodes_[from].before) found.push_back({*nodes_[from].before, nodes_[from].motion_way});
  for (const NodeIndex next : next_of_[from]) found.push_back({next, nodes_[next].motion_way});
  for (const std::size_t i : ties_of_[from]) {
    const Tie& tie = ties_[i];
    if (chiSquare(tie) > kAgreed) continue;
    found.push_back({tie.place == from ? tie.node : tie.place, kTieWay});
  }
}

RelaxationProblem ScanGraph::problemOf(const std::vector<NodeIndex>& free, int session,
                                       int trusted) const {
  RelaxationProblem problem;
  problem.errors = errors_;
  std::unordered_map<NodeIndex, std::size_t> at;
  const auto indexOf = [&](NodeIndex node, bool held) {
    const auto [found, is_new] = at.emplace(node, problem.poses.size());
    if (is_new) {
      problem.poses.push_back(nodes_[node].pose);
      problem.held.push_back(held ? 1 : 0);
    }
    return found->second;
  };
  for (const NodeIndex node : free) indexOf(node, false);
  const auto addMotion = [&](NodeIndex node) {
    const ScanNode& to = nodes_[node];
    if (!to.before || nodes_[*to.before].session != session) return;
    problem.relatives.push_back({indexOf(*to.before, true), indexOf(node, true), to.motion,
                                 motionInformation(to.motion_way, to.motion_turn), to.motion_way,
                                 to.motion_turn, 0.0});
  };
  for (const NodeIndex node : free) {
    addMotion(node);
    for (const NodeIndex next : next_of_[node]) {
      // Where it is free too, its own turn adds this.
      if (at.find(next) == at.end() || problem.held[at[next]]) addMotion(next);
    }
    for (const std::size_t i : ties_of_[node]) {
      const Tie& tie = ties_[i];
      const NodeIndex other = tie.place == node ? tie.node : tie.place;
      const auto found = at.find(other);
      const bool other_free = found != at.end() && !problem.held[found->second];
      if (other_free && tie.place == node) continue;  // from the node's side
      problem.relatives.push_back({indexOf(tie.place, true), indexOf(tie.node, true), tie.relative,
                                   tie.information, -1.0, 0.0,
                                   trusted != 0 && tie.closure == trusted ? 0.0 : kTieDoubt});
    }
    if (nodes_[node].compass && ties_of_[node].empty()) {
      problem.yaws.push_back(
          {at[node], *nodes_[node].compass, 1.0 / (kCompassSigma * kCompassSigma)});
    }
  }
  return problem;
}

void ScanGraph::relaxRecent(std::size_t count) {
  if (nodes_.empty()) return;
  const int session = nodes_.back().session;
  std::vector<NodeIndex> free;
  for (std::size_t i = nodes_.size(); i-- > 1 && free.size() < count;) {
    if (nodes_[i].session != session || !nodes_[i].before) break;
    free.push_back(i);
  }
  if (free.empty()) return;
  std::reverse(free.begin(), free.end());
  RelaxationProblem problem = problemOf(free, session, 0);
  RelaxationOptions options;
  options.iterations = 4;
  relax(problem, options);
  for (std::size_t i = 0; i < free.size(); ++i) nodes_[free[i]].pose = problem.poses[i];
}

void ScanGraph::relaxAll(int session, int iterations, int trusted) {
  std::vector<NodeIndex> all;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].session == session) all.push_back(i);
  }
  if (all.size() < 2) return;
  RelaxationProblem problem = problemOf(all, session, trusted);
  problem.held[0] = 1;
  problem.find_errors = true;
  RelaxationOptions options;
  options.iterations = iterations;
  const RelaxationResult result = relax(problem, options);
  for (std::size_t i = 0; i < all.size(); ++i) nodes_[all[i]].pose = problem.poses[i];
  errors_ = problem.errors;
  if (result.error_sigmas) error_sigmas_ = *result.error_sigmas;
}

void ScanGraph::cutBefore(NodeIndex node) {
  if (!nodes_[node].before) return;
  std::vector<NodeIndex>& next = next_of_[*nodes_[node].before];
  next.erase(std::remove(next.begin(), next.end(), node), next.end());
  nodes_[node].before.reset();
}

void ScanGraph::split(NodeIndex first, int session, const Pose2d& session_from_poses) {
  for (NodeIndex at = first; at < nodes_.size(); ++at) {
    nodes_[at].session = session;
    nodes_[at].pose = session_from_poses * nodes_[at].pose;
  }
}

ScanGraph::Lie ScanGraph::lie() const {
  Lie lie{{}, errors_, error_sigmas_};
  lie.poses.reserve(nodes_.size());
  for (const ScanNode& node : nodes_) lie.poses.push_back(node.pose);
  return lie;
}

void ScanGraph::setLie(const Lie& lie) {
  for (std::size_t i = 0; i < lie.poses.size(); ++i) nodes_[i].pose = lie.poses[i];
  errors_ = lie.errors;
  error_sigmas_ = lie.error_sigmas;
}

void ScanGraph::join(int session, int into, const Pose2d& into_from_session) {
  for (ScanNode& node : nodes_) {
    if (node.session != session) continue;
    node.session = into;
    node.pose = into_from_session * node.pose;
  }
}

}  // namespace place_memory::core
