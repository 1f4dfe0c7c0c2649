#include "core/memory/travelled_links.h"

#include <algorithm>

#include "core/map/link_odds.h"
#include "core/memory/link_pose.h"

namespace place_memory::core {
namespace {

constexpr char kDriving[] = "driving";  // the source of traversals

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
  const Ends ends = std::minmax(travel.from, travel.to);
  auto found = links_.find(ends);
  if (found == links_.end()) {
    if (const PlaceLink* known = map_.findLink(travel.from, travel.to)) {
      found = links_.emplace(ends, *known).first;
    } else {
      // Odometry's frame is taken where the robot departed.
      const Stand there{travel.from, (from_from_robot * travel.from_from_departure).inverse(), {}};
      const Stand here{
          travel.to, travel.motion * (to_from_robot * travel.to_from_arrival).inverse(), {}};
      found = links_.emplace(ends, makeLink(there, here)).first;
      edits_.emplace_back(LinkAdded{found->second});
    }
  }
  PlaceLink& link = found->second;
  LinkDirection& direction = travel.from == link.first ? link.forward : link.backward;
  if (travel.arrived <= direction.last) return;
  const Traversal traversal{travel.from,    travel.to, travel.departed,
                            travel.arrived, true,      kDriving};
  direction =
      learned(direction, traversal, expectedTime(link, direction, learning_), learning_.half_life);
  edits_.emplace_back(LinkLearned{travel.from, travel.to, direction, traversal});
}

}  // namespace place_memory::core
