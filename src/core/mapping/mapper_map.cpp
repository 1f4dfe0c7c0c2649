// How the map grows and is corrected.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/mapping/mapper.h"

namespace place_memory::core {
namespace {

constexpr int kCarried = 2;  ///< closures refused since the last tie
constexpr double kLostAfterClosure = 0.05;
/// No tie may be further off than three sigma: of three numbers together [sigma^2].
constexpr double kFarOff = 14.2;
constexpr int kSteps = 15;  ///< of a relaxation after a change of what is known

}  // namespace

std::vector<MappedPlace> Mapper::places() const {
  std::vector<MappedPlace> places;
  for (const auto& [id, at] : shelf_.places()) {
    const ScanNode& node = graph_.node(at);
    places.push_back(
        {id, "place_" + std::to_string(id), node.stamp, node.pose, node.session != kMapSession});
  }
  return places;
}

bool Mapper::closeLoops(double way) {
  const bool moves_map = options_.mode == MapperMode::kMap;
  bool closed = false;
  if (const ClosureCandidate* loop = loops_.accepted()) {
    closed = closer_.close(*loop, session_, session_, moves_map, way);
    note(closed ? MapperEvent::Kind::kClosed : MapperEvent::Kind::kRefused, loop);
    if (!closed) loops_.dropForemost();
    // Witnesses enough, and still odometry cannot have brought the robot there: it was carried.
    if (!closed && ++refused_ >= kCarried && session_ == kMapSession && !graph_.ties().empty()) {
      partWays();
      return false;
    }
  }
  if (!closed && session_ != kMapSession) {
    if (const ClosureCandidate* join = joins_.accepted()) {
      closed = closer_.close(*join, session_, kMapSession, moves_map, way);
      note(closed ? MapperEvent::Kind::kJoined : MapperEvent::Kind::kRefused, join);
      if (!closed) joins_.dropForemost();
      if (closed) session_ = kMapSession;
    }
  }
  if (!closed) return false;
  if (moves_map) {
    afterRelaxing();
  } else {
    graph_.relaxRecent(kWindow);
  }
  loops_.clear();
  joins_.clear();
  lost_.set(kLostAfterClosure);
  return true;
}

void Mapper::takeBack() {
  note(MapperEvent::Kind::kTakenBack);
  if (const std::optional<int> apart = closer_.splitSession()) session_ = *apart;
  if (options_.mode == MapperMode::kMap) {
    graph_.relaxAll(session_, kSteps);
    afterRelaxing();
  }
  // Places that had gone because they seemed doubled are made anew.
  undecided_.clear();
  for (NodeIndex at = 0; at < graph_.nodes().size(); ++at) {
    if (graph_.node(at).session == session_) undecided_.push_back(at);
  }
}

void Mapper::afterRelaxing() {
  scans_since_full_ = 0;
  ties_since_full_ = false;
  // Of places that have come to lie on each other the newer one goes; its scan stays in the graph.
  graph_.untie([this](const Tie& tie) { return graph_.chiSquare(tie) > kFarOff; });
  shelf_.follow(graph_);
  // So does an older one that lies on one that a person named; those stay.
  std::set<PlaceId> doubled;
  for (const auto& [id, at] : shelf_.places()) {
    const ScanNode& node = graph_.node(at);
    for (const PlaceShelf::Near& near :
         shelf_.near(node.pose, node.session, options_.doubled, false)) {
      if (near.id >= id) continue;
      const PlaceId goes = named_.count(id) == 0 ? id : near.id;
      if (named_.count(goes) == 0) doubled.insert(goes);
      if (goes == id) break;
    }
  }
  for (const PlaceId id : doubled) {
    shelf_.remove(id, graph_);
    belief_.forget(id);
  }
}

void Mapper::thinOut() {
  // Who refers to nodes by their indices is empty then, but for the shelf.
  if (!loops_.empty() || !joins_.empty() || !undecided_.empty() || closer_.onTrial() != 0) return;
  const auto now = thin(graph_, options_.thinning);
  if (!now) return;
  shelf_.renumber(*now);
  const auto of_drive = now->begin() + static_cast<std::ptrdiff_t>(first_of_drive_);
  first_of_drive_ = static_cast<NodeIndex>(
      std::count_if(now->begin(), of_drive, [](const auto& kept) { return kept.has_value(); }));
}

void Mapper::restore(const KeptMap& map) {
  if (!graph_.nodes().empty()) throw std::invalid_argument("the mapper has a map already");
  for (NodeIndex at = 0; at < map.nodes.size(); ++at) {
    const ScanNode& node = map.nodes[at];
    if (!node.pose.isFinite() || (node.before && *node.before >= at)) {
      throw std::invalid_argument("node " + std::to_string(at) + " of the map is damaged");
    }
    if (node.place != kNoPlace && !node.readings) {
      throw std::invalid_argument("place " + std::to_string(node.place) + " has no readings");
    }
    last_session_ = std::max(last_session_, node.session);
  }
  for (const Tie& tie : map.ties) {
    if (std::max(tie.node, tie.place) >= map.nodes.size() || !tie.information.allFinite()) {
      throw std::invalid_argument("a tie of the map is damaged");
    }
  }
  graph_.assign(map.nodes, map.ties, map.errors);
  named_ = {map.named.begin(), map.named.end()};
  shelf_.restore(graph_, map.next_place);
  first_of_drive_ = map.nodes.size();
  setMode(options_.mode);
  beginSession();
}

void Mapper::makePlaces() {
  const auto pending = [](const ClosureCandidates& candidates) {
    const ClosureCandidate* best = candidates.foremost();
    return best && best->witnesses.size() >= 2;
  };
  if (pending(loops_) || pending(joins_)) return;
  for (const NodeIndex at : undecided_) {
    const ScanNode& node = graph_.node(at);
    if (shelf_.near(node.pose, node.session, options_.spacing, false).empty()) {
      shelf_.add(at, graph_);
    }
  }
  undecided_.clear();
}

}  // namespace place_memory::core
