#include "tools/clock_topic.h"

#include <ros/time.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>

#include <boost/algorithm/string/join.hpp>
#include <set>

#include "tools/stored_message.h"

namespace place_memory::tools {
namespace {

// A bag that is played again sets time back too, but now and then only.
constexpr int kManySteps = 3;

}  // namespace

std::string severalClocks(const rosbag::Bag& bag) {
  rosbag::View view(bag, [](const rosbag::ConnectionInfo* connection) {
    return withoutSlash(connection->topic) == "clock";
  });
  std::set<std::string> publishers;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (!connection->header) continue;
    const auto caller = connection->header->find("callerid");
    if (caller != connection->header->end()) publishers.insert(caller->second);
  }
  ros::Time newest;
  int steps_back = 0;
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = tryLoad(instance);
    const auto clock = message ? message->as<rosgraph_msgs::Clock>() : nullptr;
    if (!clock) continue;
    if (clock->clock < newest) ++steps_back;
    newest = clock->clock;
  }
  const bool several = publishers.size() > 1;
  if (!several && steps_back < kManySteps) return {};
  std::string text = "/clock came from several sources";
  if (several) text += " (" + boost::algorithm::join(publishers, ", ") + ")";
  if (steps_back > 0) text += ", and went back " + std::to_string(steps_back) + " times";
  return text +
         ": stamps are of different times; record again with one of them, as without --clock where "
         "a bag is played beside a simulator";
}

}  // namespace place_memory::tools
