#include "node/scan/scan_topics.h"

#include <ros/console.h>

#include <algorithm>
#include <boost/algorithm/string/join.hpp>

#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

// The names that the launch file's arguments stand for.
constexpr char kSonarName[] = "sonar";
constexpr char kHeadingName[] = "heading";

}  // namespace

config::Parameters withResolvedTopics(const ros::NodeHandle& names,
                                      const config::Parameters& parameters) {
  config::Parameters resolved = parameters;
  for (std::string& topic : resolved.sonar_topics) topic = names.resolveName(topic);
  for (std::string* topic : {&resolved.heading_topic, &resolved.odom_topic}) {
    if (!topic->empty()) *topic = names.resolveName(*topic);
  }
  return resolved;
}

std::vector<std::string> vainRemappings(const ros::NodeHandle& names,
                                        const config::Parameters& parameters) {
  std::vector<std::string> sentences;
  const auto check = [&](const std::string& name, bool is_used, const std::string& parameter) {
    const std::string remapped = names.resolveName(name);
    if (is_used || remapped == names.resolveName(name, false)) return;
    sentences.push_back(name + " is remapped to " + remapped + " (" + name +
                        ":=), but nothing listens to it, since the parameter " + parameter +
                        " does not name it: put " + name + " into " + parameter +
                        ", or leave one of the two out");
  };
  const std::vector<std::string>& sonars = parameters.sonar_topics;
  check(kSonarName, std::find(sonars.begin(), sonars.end(), kSonarName) != sonars.end(),
        "sonar_topics");
  check(kHeadingName, parameters.heading_topic == kHeadingName, "heading_topic");
  return sentences;
}

void sayTopics(const ros::NodeHandle& names, const config::Parameters& parameters) {
  const config::Parameters resolved = withResolvedTopics(names, parameters);
  const std::string odometry =
      resolved.odom_topic.empty() ? "" : " (by " + resolved.odom_topic + ")";
  const std::string tf = (parameters.odom_frame.empty() ? "" : parameters.odom_frame + " -> ") +
                         parameters.base_frame + odometry + " -> sensors";
  const std::string heading = resolved.heading_topic.empty()
                                  ? "none (scans lie by odometry's yaw, any heading is sought)"
                                  : resolved.heading_topic;
  ROS_INFO("sonar %s; heading %s; tf %s; map frame %s; turns by %s",
           boost::algorithm::join(resolved.sonar_topics, ", ").c_str(), heading.c_str(), tf.c_str(),
           parameters.map_frame.c_str(), names.resolveName(kCommandTopic).c_str());
  for (const std::string& sentence : vainRemappings(names, parameters)) {
    ROS_WARN("%s", sentence.c_str());
  }
}

void sayOutcome(const ScanOutcome& outcome) {
  if (outcome.scan) {
    ROS_INFO("scan %llu: %s%s%s", static_cast<unsigned long long>(outcome.scan->id),
             outcome.message.c_str(), outcome.problem.empty() ? "" : "; ", outcome.problem.c_str());
  } else {
    ROS_WARN("no scan (%s): %s", toString(outcome.status), outcome.message.c_str());
  }
}

}  // namespace place_memory::node
