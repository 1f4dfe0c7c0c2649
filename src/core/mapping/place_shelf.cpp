#include "core/mapping/place_shelf.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

constexpr double kBucket = 1.5;                  // [m]
constexpr double kLaidAnew = 2.0 * kPi / 180.0;  // [rad]

Pose2d gridPose(const ScanNode& node) { return node.pose * baseFromGrid(node, node.laid_yaw); }

}  // namespace

PlaceId PlaceShelf::add(NodeIndex at, ScanGraph& graph, PlaceId wanted) {
  const PlaceId id = wanted == kNoPlace ? last_id_ + 1 : wanted;
  last_id_ = std::max(last_id_, id);
  graph.node(at).place = id;
  node_of_[id] = at;
  const ScanNode& node = graph.node(at);
  put(id, node);
  unripe_.push_back(id);
  return id;
}

void PlaceShelf::remove(PlaceId id, ScanGraph& graph) {
  ScanNode& node = graph.node(node_of_.at(id));
  node.place = kNoPlace;
  locators_.at(node.session).erase(id);
  seen_.at(node.session).erase(id);
  const auto home = home_of_.find(id);
  if (home != home_of_.end()) {
    matchers_.at(home->second).erase(id);
    home_of_.erase(home);
  }
  unripe_.erase(std::remove(unripe_.begin(), unripe_.end(), id), unripe_.end());
  node_of_.erase(id);
}

void PlaceShelf::shelve(PlaceId id, ScanGraph& graph) {
  ScanNode& node = graph.node(node_of_.at(id));
  node.laid_yaw = node.pose.yaw;
  const EvidenceGrid grid = sonar_.build(
      movedReadings(*node.readings, baseFromGrid(node, node.laid_yaw).inverse()), geometry_);
  matchers_.try_emplace(node.session, options_).first->second.put(id, gridPose(node), grid);
  home_of_[id] = node.session;
}

void PlaceShelf::ripen(double way, ScanGraph& graph) {
  const auto ripe = [&](PlaceId id) {
    if (graph.node(node_of_.at(id)).last_way >= way) return false;
    shelve(id, graph);
    return true;
  };
  unripe_.erase(std::remove_if(unripe_.begin(), unripe_.end(), ripe), unripe_.end());
}

void PlaceShelf::follow(ScanGraph& graph) {
  locate(graph);
  for (const auto& [id, session] : home_of_) {
    const ScanNode& node = graph.node(node_of_.at(id));
    if (std::abs(wrapAngle(node.pose.yaw - node.laid_yaw)) > kLaidAnew) {
      shelve(id, graph);
    } else {
      matchers_.at(session).move(id, gridPose(node));
    }
  }
}

void PlaceShelf::join(int session, int into, const ScanGraph& graph) {
  locate(graph);
  const auto from = matchers_.find(session);
  if (from == matchers_.end()) return;
  matchers_.try_emplace(into, options_).first->second.takeAll(from->second);
  matchers_.erase(from);
  for (auto& [id, home] : home_of_) {
    if (home == session) home = into;
  }
}

void PlaceShelf::resort(ScanGraph& graph) {
  locate(graph);
  for (auto& [id, home] : home_of_) {
    if (graph.node(node_of_.at(id)).session == home) continue;
    matchers_.at(home).erase(id);
    shelve(id, graph);
  }
}

void PlaceShelf::renumber(const std::vector<std::optional<NodeIndex>>& now) {
  for (auto& [id, at] : node_of_) at = *now[at];
}

void PlaceShelf::restore(ScanGraph& graph, PlaceId next_id) {
  last_id_ = std::max(last_id_, next_id - 1);
  for (NodeIndex at = 0; at < graph.nodes().size(); ++at) {
    const PlaceId id = graph.node(at).place;
    if (id == kNoPlace) continue;
    node_of_[id] = at;
    last_id_ = std::max(last_id_, id);
    shelve(id, graph);
  }
  locate(graph);
}

const PlaceMatcher* PlaceShelf::matcher(int session) const {
  const auto found = matchers_.find(session);
  return found == matchers_.end() || found->second.size() == 0 ? nullptr : &found->second;
}

std::vector<PlaceShelf::Near> PlaceShelf::near(const Pose2d& pose, int session, double radius,
                                               bool only_ripe) const {
  return near(locators_, pose, session, radius, only_ripe);
}

std::vector<PlaceShelf::Near> PlaceShelf::nearSeen(const Pose2d& pose, const Pose2d& seen,
                                                   int session, double radius) const {
  return near(seen_, pose * seen, session, radius, true);
}

std::vector<PlaceShelf::Near> PlaceShelf::near(const std::map<int, PlaceLocator>& locators,
                                               const Pose2d& pose, int session, double radius,
                                               bool only_ripe) const {
  const auto locator = locators.find(session);
  if (locator == locators.end()) return {};
  std::vector<Near> found = locator->second.near(pose, radius);
  if (only_ripe) {
    found.erase(std::remove_if(found.begin(), found.end(),
                               [this](const Near& near) { return !ripe(near.id); }),
                found.end());
  }
  return found;
}

void PlaceShelf::locate(const ScanGraph& graph) {
  locators_.clear();
  seen_.clear();
  for (const auto& [id, at] : node_of_) {
    put(id, graph.node(at));
  }
}

void PlaceShelf::put(PlaceId id, const ScanNode& node) {
  locators_.try_emplace(node.session, kBucket).first->second.put(id, node.pose);
  seen_.try_emplace(node.session, kBucket).first->second.put(id, node.pose * node.seen);
}

}  // namespace place_memory::core
