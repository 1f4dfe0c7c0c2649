#include "core/memory/store_merge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/memory/frame_consensus.h"
#include "core/memory/link_pose.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kLeastWitnesses = 3;
constexpr double kSamePlace = 0.6;  // [m]

/// What a place of theirs is in the map.
struct Counterpart {
  PlaceId id = kNoPlace;
  Pose2d ours_from_theirs;
};

using Counterparts = std::map<PlaceId, Counterpart>;

PlaceAdded takenOver(const Place& place, const PlaceStore& store) {
  return {place, std::make_shared<const EvidenceGrid>(store.grid(place.id)),
          std::make_shared<const std::vector<SonarReading>>(store.readings(place.id))};
}

/// Adds the links of `theirs` between places that have counterparts, where there is none yet.
void addLinks(const PlaceMap& theirs, const PlaceMap* ours, const Counterparts& counterparts,
              std::vector<MapEdit>& edits) {
  std::set<std::pair<PlaceId, PlaceId>> linked;
  for (PlaceLink link : theirs.links()) {
    const auto first = counterparts.find(link.first);
    const auto second = counterparts.find(link.second);
    if (first == counterparts.end() || second == counterparts.end()) continue;
    link.first_from_second = first->second.ours_from_theirs * link.first_from_second *
                             second->second.ours_from_theirs.inverse();
    link.covariance = turned(link.covariance, first->second.ours_from_theirs.yaw);
    link.first = first->second.id;
    link.second = second->second.id;
    if (link.first == link.second) continue;
    if (link.first > link.second) link = seenFromSecond(link);
    const bool is_there = ours != nullptr && ours->findLink(link.first, link.second) != nullptr;
    if (is_there || !linked.emplace(link.first, link.second).second) continue;
    edits.emplace_back(LinkAdded{link});
  }
}

std::string freeLabel(const std::string& label, const std::set<std::string>& taken) {
  for (int number = 2;; ++number) {
    std::string free = label + " (" + std::to_string(number) + ")";
    if (taken.count(free) == 0) return free;
  }
}

class Merge {
 public:
  Merge(const PlaceMap& ours, const PlaceMap& theirs, const PlaceStore& store,
        const std::vector<MergeSighting>& sightings)
      : ours_(ours), theirs_(theirs), store_(store) {
    for (const Place& place : ours.places()) {
      labels_.insert(place.label);
      if (place.identity != PlaceIdentity{}) ours_by_identity_[place.identity] = &place;
    }
    for (const Place& place : theirs.places()) {
      labels_of_theirs_.insert(place.label);
      const auto same = ours_by_identity_.find(place.identity);
      if (same != ours_by_identity_.end()) pair(place, *same->second, Pose2d{}, true);
    }
    for (const MergeSighting& sighting : sightings) {
      const Place* place = ours.find(sighting.ours);
      const Place* seen = theirs.find(sighting.theirs);
      if (place != nullptr && seen != nullptr) {
        pair(*seen, *place, sighting.ours_from_theirs, false);
      }
    }
  }

  MergePlan plan(PlaceId next_id, SessionId next_session) {
    std::map<SessionId, std::vector<const Place*>> sessions;
    for (const Place& place : theirs_.places()) sessions[place.session].push_back(&place);
    for (const auto& [session, places] : sessions) {
      const auto consensus =
          frameConsensus(pairs_[session], std::min(kLeastWitnesses, places.size()));
      if (consensus) {
        ++plan_.report.joined;
        frames_[session] = *consensus;
      } else {
        frames_[session] = {next_session++, Pose2d{}};
        is_apart_.insert(session);
      }
    }
    for (const Place& place : theirs_.places()) take(place, next_id);
    plan_.report.apart = static_cast<std::size_t>(
        std::count_if(is_apart_.begin(), is_apart_.end(),
                      [this](SessionId session) { return has_new_.count(session) > 0; }));
    addLinks(theirs_, &ours_, counterparts_, plan_.edits);
    return std::move(plan_);
  }

 private:
  void pair(const Place& theirs, const Place& ours, const Pose2d& ours_from_theirs, bool sure) {
    pairs_[theirs.session].push_back({ours.session, ours.map_from_place * ours_from_theirs,
                                      theirs.map_from_place, ours.id, sure});
    const Pose2d robot = ours_from_theirs * theirs.place_from_robot;
    const Pose2d& stood = ours.place_from_robot;
    if (sure || std::hypot(robot.x - stood.x, robot.y - stood.y) <= kSamePlace) {
      same_.emplace(theirs.id, std::make_pair(Counterpart{ours.id, ours_from_theirs},
                                              pairs_[theirs.session].back()));
    }
  }

  /// What it is in the map already, if anything.
  std::optional<Counterpart> knownAs(const Place& theirs) const {
    const auto same = same_.find(theirs.id);
    if (same == same_.end()) return std::nullopt;
    const auto& [counterpart, pair] = same->second;
    // Of a session apart a sighting may be wrong.
    const bool is_right = pair.sure || (is_apart_.count(theirs.session) == 0 &&
                                        agrees(frames_.at(theirs.session), pair, 0.0));
    return is_right ? std::optional<Counterpart>(counterpart) : std::nullopt;
  }

  void take(const Place& theirs, PlaceId& next_id) {
    if (const auto known = knownAs(theirs)) {
      ++plan_.report.known;
      counterparts_[theirs.id] = *known;
      return;
    }
    PlaceAdded edit = takenOver(theirs, store_);
    const FrameConsensus& frame = frames_.at(theirs.session);
    edit.place.id = next_id++;
    edit.place.session = frame.session;
    edit.place.map_from_place = frame.into_from_from * theirs.map_from_place;
    if (labels_.count(theirs.label) > 0) {
      std::set<std::string> taken = labels_;
      taken.insert(labels_of_theirs_.begin(), labels_of_theirs_.end());
      edit.place.label = freeLabel(theirs.label, taken);
      plan_.report.collisions.push_back({theirs.label, edit.place.label});
    }
    labels_.insert(edit.place.label);
    has_new_.insert(theirs.session);
    counterparts_[theirs.id] = {edit.place.id, Pose2d{}};
    plan_.edits.emplace_back(std::move(edit));
    ++plan_.report.added;
  }

  const PlaceMap& ours_;
  const PlaceMap& theirs_;
  const PlaceStore& store_;
  std::map<PlaceIdentity, const Place*> ours_by_identity_;
  std::set<std::string> labels_;
  std::set<std::string> labels_of_theirs_;
  std::map<SessionId, std::vector<FramePair>> pairs_;
  std::map<PlaceId, std::pair<Counterpart, FramePair>> same_;  ///< by their id
  std::map<SessionId, FrameConsensus> frames_;
  std::set<SessionId> is_apart_;
  std::set<SessionId> has_new_;
  Counterparts counterparts_;
  MergePlan plan_;
};

}  // namespace

Scan scanOf(const Place& place, const PlaceStore& store) {
  Scan scan;
  scan.grid = store.grid(place.id);
  scan.readings = store.readings(place.id);
  scan.odom_from_scan = place.map_from_place;
  scan.robot_in_scan = place.place_from_robot;
  scan.begin = place.learned;
  scan.end = place.learned;
  return scan;
}

MergePlan planMerge(const PlaceMap& ours, const PlaceMap& theirs, const PlaceStore& store,
                    const std::vector<MergeSighting>& sightings, PlaceId next_id,
                    SessionId next_session) {
  return Merge(ours, theirs, store, sightings).plan(next_id, next_session);
}

std::vector<MapEdit> replacingEdits(const PlaceMap& theirs, const PlaceStore& store,
                                    PlaceId next_id, SessionId next_session) {
  std::vector<MapEdit> edits{MapCleared{}};
  Counterparts counterparts;
  // One after the other, the oldest first. Numbers that theirs are added to would double each time
  // that a map is saved and loaded.
  std::map<SessionId, SessionId> sessions;
  for (const Place& place : theirs.places()) sessions.emplace(place.session, kNoSession);
  for (auto& session : sessions) session.second = next_session++;
  for (const Place& place : theirs.places()) {
    PlaceAdded edit = takenOver(place, store);
    edit.place.id = next_id++;
    edit.place.session = sessions.at(place.session);
    counterparts[place.id] = {edit.place.id, Pose2d{}};
    edits.emplace_back(std::move(edit));
  }
  addLinks(theirs, nullptr, counterparts, edits);
  return edits;
}

}  // namespace place_memory::core
