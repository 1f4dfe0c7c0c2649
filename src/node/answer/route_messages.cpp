#include "node/answer/route_messages.h"

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>

#include "node/answer/answer_words.h"
#include "node/base/conversions.h"

namespace place_memory::node {

nav_msgs::Path toPath(const std::vector<core::Place>& places, const std::string& map_frame) {
  nav_msgs::Path path;
  path.header = makeHeader(map_frame, ros::Time());
  std::vector<core::Pose2d> stands;
  stands.reserve(places.size());
  for (const core::Place& place : places) {
    stands.push_back(place.map_from_place * place.place_from_robot);
  }
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const std::size_t from = i + 1 < stands.size() ? i : i - 1;
    if (stands.size() > 1) {
      stands[i].yaw =
          std::atan2(stands[from + 1].y - stands[from].y, stands[from + 1].x - stands[from].x);
    }
    geometry_msgs::PoseStamped pose;
    pose.header = path.header;
    pose.pose = toPose(stands[i]);
    path.poses.push_back(pose);
  }
  return path;
}

Route toMessage(const core::Route& route, const std::vector<core::Place>& places,
                const std::string& map_frame) {
  Route message;
  for (const core::Place& place : places) {
    message.ids.push_back(place.id);
    message.labels.push_back(place.label);
  }
  message.path = toPath(places, map_frame);
  message.cost = route.cost;
  message.time = route.time;
  message.time_sigma = route.time_sigma;
  message.odds = route.odds;
  return message;
}

std::string inWords(const core::Route& route, const std::vector<core::Place>& places) {
  if (places.size() == 1) return "the robot is at " + quoted(places.front().label) + " already";
  std::ostringstream text;
  const std::size_t links = places.size() - 1;
  text << quoted(places.front().label) << " to " << quoted(places.back().label) << ", " << links
       << (links == 1 ? " link" : " links") << std::fixed << std::setprecision(0) << ", about "
       << route.cost << " s (" << route.time << " s where all is open), odds "
       << std::setprecision(2) << route.odds;
  return text.str();
}

}  // namespace place_memory::node
