#include "core/memory/travelled_links.h"

#include <algorithm>

#include "core/memory/link_pose.h"

namespace place_memory::core {
namespace {

void count(const PlaceTravel& travel, LinkDirection& direction) {
  if (travel.arrived <= direction.last) return;
  ++direction.succeeded;
  direction.last = travel.arrived;
}

/// `there` and `here`: where the robot's odometry had the two places.
PlaceLink makeLink(const Stand& there, const Stand& here) {
  PlaceLink link = there.place < here.place
                       ? linkTo(here.place, here.odom_from_place, there, true, {})
                       : linkTo(there.place, there.odom_from_place, here, true, {});
  link.forward = LinkDirection{};
  return link;
}

}  // namespace

void TravelledLinks::add(const PlaceTravel& travel, const Pose2d& from_from_robot,
                         const Pose2d& to_from_robot) {
  if (const PlaceLink* known = map_.findLink(travel.from, travel.to)) {
    const bool forward = travel.from < travel.to;
    const auto direction = travelled_.emplace(Ends{travel.from, travel.to},
                                              forward ? known->forward : known->backward);
    count(travel, direction.first->second);
    return;
  }
  const Ends ends = std::minmax(travel.from, travel.to);
  auto link = added_.find(ends);
  if (link == added_.end()) {
    // Odometry's frame is taken where the robot departed.
    const Stand there{travel.from, (from_from_robot * travel.from_from_departure).inverse(), {}};
    const Stand here{
        travel.to, travel.motion * (to_from_robot * travel.to_from_arrival).inverse(), {}};
    link = added_.emplace(ends, makeLink(there, here)).first;
  }
  count(travel, travel.from < travel.to ? link->second.forward : link->second.backward);
}

void TravelledLinks::appendTo(std::vector<MapEdit>& edits) const {
  for (const auto& [ends, link] : added_) edits.emplace_back(LinkAdded{link});
  for (const auto& [ends, direction] : travelled_) {
    const PlaceLink& known = *map_.findLink(ends.first, ends.second);
    const LinkDirection& before = ends.first < ends.second ? known.forward : known.backward;
    if (direction == before) continue;
    edits.emplace_back(LinkLearned{ends.first, ends.second, direction});
  }
}

}  // namespace place_memory::core
