#include "core/memory/whereabouts.h"

namespace place_memory::core {

WhereaboutsOwner::WhereaboutsOwner(bool located, bool map_is_empty, SessionId next_session)
    : located_(located) {
  beginStretch(map_is_empty);
  if (located && map_is_empty) now_.session = next_session;
}

void WhereaboutsOwner::beginStretch(bool map_is_empty) {
  ++stretch_;
  ++now_.version;
  now_.session = located_ ? kNoSession : kFirstSession;
  now_.map_from_odom.reset();
  if (!located_ || (map_is_empty && !driven_)) now_.map_from_odom = Pose2d{};
  now_.apart = false;
  now_.previous = kNoPlace;
  now_.current = kNoPlace;
  now_.current_label.clear();
  previous_.reset();
  // What was asked before tells where the robot was then.
  newest_answer_ = ++questions_;
}

void WhereaboutsOwner::standAt(const Place& place, const Stand& stand) {
  previous_ = stand;
  now_.previous = place.id;
  now_.current = place.id;
  now_.current_label = place.label;
}

Footing WhereaboutsOwner::footing(SessionId next_session) const {
  Footing footing;
  footing.session = now_.session == kNoSession ? next_session : now_.session;
  footing.map_from_odom = now_.map_from_odom.value_or(Pose2d{});
  footing.apart = now_.apart || !now_.map_from_odom;
  footing.previous = previous_;
  footing.stretch = stretch_;
  footing.driven = driven_;
  return footing;
}

std::optional<SessionJoin> WhereaboutsOwner::learned(std::uint64_t question, const Footing& footing,
                                                     const Place& place,
                                                     const Pose2d& odom_from_scan) {
  if (footing.stretch != stretch_) return std::nullopt;
  ++now_.version;
  if (question >= newest_answer_) {
    newest_answer_ = question;
    standAt(place, {place.id, odom_from_scan, {}});
  }
  if (now_.session == kNoSession) {
    now_.session = footing.session;
    now_.map_from_odom = footing.map_from_odom;
    now_.apart = footing.apart;
  }
  if (driven_ || now_.session == footing.session) return std::nullopt;
  return SessionJoin{footing.session, now_.session,
                     *now_.map_from_odom * footing.map_from_odom.inverse()};
}

std::optional<SessionJoin> WhereaboutsOwner::settleFrame(const Sighting& sighting) {
  const Place& place = sighting.place;
  const Pose2d map_from_odom =
      place.map_from_place * sighting.place_from_scan * sighting.odom_from_scan.inverse();
  const bool is_known = now_.session != kNoSession && now_.map_from_odom.has_value();
  if (is_known && now_.session < place.session) {
    // The later session moves: people and programs know the frame of the earlier one.
    return SessionJoin{place.session, now_.session, *now_.map_from_odom * map_from_odom.inverse()};
  }
  std::optional<SessionJoin> join;
  if (is_known && now_.session != place.session) {
    join = {now_.session, place.session, map_from_odom * now_.map_from_odom->inverse()};
  }
  if (now_.session != place.session) now_.apart = false;
  now_.session = place.session;
  now_.map_from_odom = map_from_odom;
  return join;
}

Settled WhereaboutsOwner::recognized(std::uint64_t question, const Sighting& sighting) {
  if (question < newest_answer_) return {true, kNoPlace, std::nullopt};
  newest_answer_ = question;
  ++now_.version;
  Settled settled{false, driven_ ? kNoPlace : now_.previous, std::nullopt};
  if (located_ && !driven_) settled.join = settleFrame(sighting);
  standAt(sighting.place,
          {sighting.place.id, sighting.odom_from_scan * sighting.place_from_scan.inverse(),
           sighting.covariance});
  return settled;
}

bool WhereaboutsOwner::notRecognized(std::uint64_t question) {
  if (question < newest_answer_) return true;
  newest_answer_ = question;
  ++now_.version;
  now_.current = kNoPlace;
  now_.current_label.clear();
  return false;
}

void WhereaboutsOwner::drive(const std::optional<DriveWhereabouts>& whereabouts,
                             const Place* current) {
  driven_ = whereabouts.has_value();
  if (!driven_) return;
  ++now_.version;
  now_.session = whereabouts->session;
  now_.map_from_odom = whereabouts->map_from_odom;
  now_.apart = whereabouts->apart;
  const PlaceId at = current == nullptr ? kNoPlace : current->id;
  if (at == now_.current) return;
  newest_answer_ = ++questions_;  // what was asked before is of where the robot was
  if (at == kNoPlace) {
    now_.current = kNoPlace;
    now_.current_label.clear();
    return;
  }
  const Pose2d map_from_odom = now_.map_from_odom.value_or(Pose2d{});
  standAt(*current, {at, map_from_odom.inverse() * current->map_from_place, {}});
}

void WhereaboutsOwner::forget(bool map_is_empty) { beginStretch(map_is_empty); }

void WhereaboutsOwner::follow(const MapChange& change, bool map_is_empty) {
  for (const MapEdit& edit : change.edits) {
    if (const auto* renamed = std::get_if<PlaceRenamed>(&edit)) {
      if (renamed->id != now_.current) continue;
      now_.current_label = renamed->label;
      ++now_.version;
    } else if (const auto* removed = std::get_if<PlaceRemoved>(&edit)) {
      if (removed->id != now_.previous && removed->id != now_.current) continue;
      if (removed->id == now_.previous) {
        now_.previous = kNoPlace;
        previous_.reset();
      }
      if (removed->id == now_.current) {
        now_.current = kNoPlace;
        now_.current_label.clear();
      }
      ++now_.version;
    }
  }
  // In a map without a place nothing is known that odometry's frame could lie apart from.
  if (map_is_empty) beginStretch(true);
}

}  // namespace place_memory::core
