#include "node/answer/place_clicks.h"

#include <nav_msgs/Path.h>
#include <ros/console.h>

#include <optional>
#include <utility>

#include "node/answer/route_messages.h"

namespace place_memory::node {

PlaceClicks::PlaceClicks(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
                         AnswerPublisher& answers, Belief belief, Judge judge,
                         const config::Parameters& parameters)
    : memory_(memory),
      answers_(answers),
      belief_(std::move(belief)),
      judge_(std::move(judge)),
      parameters_(parameters) {
  ros::NodeHandle node(private_node);
  if (parameters_.markers.clickable == 0) return;
  route_ = node.advertise<nav_msgs::Path>(kRouteTopic, 1, true);
}

void PlaceClicks::choose(core::PlaceId id, PlaceEntry entry) {
  switch (entry) {
    case PlaceEntry::kRecall:
      return answers_.showPlace(id);
    case PlaceEntry::kRoute:
      return showRoute(id);
    case PlaceEntry::kConfirm:
    case PlaceEntry::kCut:
      return judge_(id, entry == PlaceEntry::kConfirm);
    case PlaceEntry::kRename:
      return;
  }
}

// Where there is no route the path is empty, so that rviz shows none, and the log says why.
void PlaceClicks::showRoute(core::PlaceId id) {
  core::RouteQuery query;
  query.goal = {id, "", std::nullopt};
  query.starts = belief_();
  query.second = false;
  const core::RoutePlan plan = memory_.plan(query);
  nav_msgs::Path path;
  path.header.frame_id = parameters_.map_frame;
  if (plan.answer.status == core::RouteAnswer::Status::kFound) {
    path = toPath(plan.best, parameters_.map_frame);
    ROS_INFO("The route: %s", inWords(plan.answer.best, plan.best).c_str());
  } else {
    ROS_WARN("There is no route to show: %s", plan.answer.reason.c_str());
  }
  route_.publish(path);
}

}  // namespace place_memory::node
