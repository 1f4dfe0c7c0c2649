// How the map grows and is corrected.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/mapping/mapper.h"

namespace place_memory::core {
namespace {

constexpr double kLostAfterClosure = 0.05;
/// No tie may be further off than three sigma: of three numbers together [sigma^2].
constexpr double kFarOff = 14.2;
/// Share of the agreement that is asked on an average which of so many witnesses one may fall short
/// of: people stand in the way, doors are shut.
constexpr double kLeastAgreement = 0.65;
constexpr std::size_t kOneFallsShort = 10;
constexpr double kMostWait = 8.0;    ///< way for which places may wait for closures [m]
constexpr double kRemembered = 3.0;  ///< places about by which a thinned scan is remembered [m]
constexpr int kSteps = 15;           ///< of a relaxation after a change of what is known

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

/// What looks alike to recognition still differs in what stands about.
const ClosureCandidate* Mapper::accepted(const ClosureCandidates& candidates, int target) const {
  const PlaceMatcher* places = shelf_.matcher(target);
  const ClosureCandidate* best = candidates.accepted(places ? places->size() : 0);
  if (!best || candidates.options().agreement == 0.0) return best;
  const double asked = candidates.options().agreement;
  double sum = 0.0;
  std::size_t count = 0, short_of_it = 0;
  for (const Witness& witness : best->witnesses) {
    const auto agrees = newest_.agreeWith(witness.place, witness.node, witness.pose);
    if (!agrees) continue;
    sum += *agrees;
    short_of_it += *agrees < kLeastAgreement * asked ? 1 : 0;
    ++count;
  }
  const bool agree = sum >= asked * static_cast<double>(count);
  return agree && kOneFallsShort * short_of_it <= count ? best : nullptr;
}

bool Mapper::closeLoops(double way) {
  if (const ClosureCandidate* loop = accepted(loops_, session_)) {
    if (close(*loop, session_, way)) return true;
    loops_.dropForemost();
  }
  if (session_ == kMapSession) return false;
  if (const ClosureCandidate* join = accepted(joins_, kMapSession)) {
    if (close(*join, kMapSession, way)) return true;
    joins_.dropForemost();
  }
  return false;
}

/// Forgets all candidates, this one too, where it closes.
bool Mapper::close(const ClosureCandidate& candidate, int target, double way) {
  const bool moves_map = options_.mode == MapperMode::kMap;
  const bool joins = target != session_;
  const bool closed = closer_.close(candidate, session_, target, moves_map, way);
  note(!closed ? MapperEvent::Kind::kRefused
       : joins ? MapperEvent::Kind::kJoined
               : MapperEvent::Kind::kClosed,
       &candidate);
  if (!closed) return false;
  session_ = target;
  anchored_way_ = way;
  if (moves_map) {
    afterRelaxing();
  } else {
    graph_.relaxRecent(kWindow);
  }
  loops_.clear();
  carried_.clear();
  joins_.clear();
  lost_.set(kLostAfterClosure);
  break_way_.reset();
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
  if (!loops_.empty() || !carried_.empty() || !joins_.empty() || !undecided_.empty() ||
      closer_.onTrial() != 0)
    return;
  const std::vector<ScanNode> before = options_.keep_way ? graph_.nodes() : std::vector<ScanNode>{};
  const auto now = thin(graph_, options_.thinning);
  if (!now) return;
  remember(before, *now);
  shelf_.renumber(*now);
  const auto of_drive = now->begin() + static_cast<std::ptrdiff_t>(first_of_drive_);
  first_of_drive_ = static_cast<NodeIndex>(
      std::count_if(now->begin(), of_drive, [](const auto& kept) { return kept.has_value(); }));
}

void Mapper::remember(const std::vector<ScanNode>& before,
                      const std::vector<std::optional<NodeIndex>>& now) {
  for (NodeIndex at = first_of_drive_; at < before.size(); ++at) {
    if (now[at]) continue;
    const auto near = shelf_.near(before[at].pose, before[at].session, kRemembered, false);
    if (near.empty()) continue;
    thinned_.push_back({before[at], near.front().id});
    ScanNode& node = thinned_.back().node;
    const NodeIndex place = *now[shelf_.nodeOf(near.front().id)];
    node.pose = graph_.node(place).pose.inverse() * node.pose;
    node.readings.reset();
    node.before.reset();
  }
}

std::vector<ScanNode> Mapper::way() const {
  std::vector<ScanNode> way;
  for (const ThinnedScan& thinned : thinned_) {
    if (!shelf_.has(thinned.place)) continue;
    const ScanNode& place = graph_.node(shelf_.nodeOf(thinned.place));
    way.push_back(thinned.node);
    way.back().session = place.session;
    way.back().pose = place.pose * thinned.node.pose;
  }
  for (NodeIndex at = first_of_drive_; at < graph_.nodes().size(); ++at) {
    way.push_back(graph_.node(at));
    way.back().readings.reset();
    way.back().before.reset();
  }
  std::sort(way.begin(), way.end(),
            [](const ScanNode& a, const ScanNode& b) { return a.stamp < b.stamp; });
  return way;
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
  // What waits for long becomes places all the same: without them the rooms that the robot drives
  // through since would be missing, and it would take each for one that looks like it.
  const bool waits = pending(loops_) || pending(carried_) || pending(joins_) || break_way_;
  auto next = undecided_.begin();
  for (; next != undecided_.end(); ++next) {
    const NodeIndex at = *next;
    const ScanNode& node = graph_.node(at);
    if (waits && reckoning_.way() - node.last_way < kMostWait) break;
    if (!shelf_.near(node.pose, node.session, options_.spacing, false).empty()) continue;
    if (node.place != kNoPlace || !node.readings) continue;
    shelf_.add(at, graph_);
    if (at + 1 < graph_.nodes().size()) decisions_.push_back(lateDecision(at));
  }
  undecided_.erase(undecided_.begin(), next);
}

}  // namespace place_memory::core
