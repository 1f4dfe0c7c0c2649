#include "tools/bag_scanner.h"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "node/base/ros_time.h"
#include "node/input/input_message.h"
#include "node/input/transform_filter.h"
#include "tools/bag_file.h"

namespace place_memory::tools {
namespace {

constexpr char kTf[] = "tf";
constexpr char kStaticTf[] = "tf_static";

// Transforms and headings so long before a scan are read too: between two of them lies its start.
const ros::Duration kLead(10.0);
// Messages are recorded so much later than they are stamped.
const ros::Duration kRecordingDelay(1.0);

// Names are the same with and without the slash: a bag has them resolved, parameters do not.
std::string withoutSlash(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

std::string joined(const std::map<std::string, std::string>& types) {
  std::string text;
  for (const auto& [name, type] : types) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

BagScanner::BagScanner(const std::string& path, const config::Parameters& parameters)
    : parameters_(parameters), intake_(parameters, withoutSlash, registry_) {
  openBag(path, bag_);
  requireTopics(path);
  readStaticTransforms();
}

void BagScanner::requireTopics(const std::string& path) {
  std::map<std::string, std::string> types;
  rosbag::View everything(bag_);
  for (const rosbag::ConnectionInfo* connection : everything.getConnections()) {
    types[withoutSlash(connection->topic)] = connection->datatype;
    topics_.push_back(connection->topic);
  }
  for (const auto& [topic, role] : intake_.topics()) {
    const auto found = types.find(withoutSlash(topic));
    if (found == types.end()) {
      throw std::runtime_error("the bag " + path + " has no topic " + topic + "; it has " +
                               joined(types));
    }
    const std::string wrong = node::wrongType(topic, role, found->second);
    if (!wrong.empty()) throw std::runtime_error("in the bag " + path + " " + wrong);
  }
  const bool needs_tf = !parameters_.odom_frame.empty() && parameters_.odom_topic.empty();
  if (needs_tf && types.count(kTf) == 0) {
    throw std::runtime_error("the bag " + path + " has no topic " + kTf + "; it has " +
                             joined(types));
  }

  const auto needless = [&](const std::string& topic) {
    const std::string name = withoutSlash(topic);
    return name != kTf && intake_.topics().count(name) == 0;
  };
  topics_.erase(std::remove_if(topics_.begin(), topics_.end(), needless), topics_.end());
}

void BagScanner::readStaticTransforms() {
  const auto is_static = [](const rosbag::ConnectionInfo* connection) {
    return withoutSlash(connection->topic) == kStaticTf;
  };
  rosbag::View view(bag_, is_static);
  for (const rosbag::MessageInstance& message : view) {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      static_transforms_.insert(static_transforms_.end(), transforms->transforms.begin(),
                                transforms->transforms.end());
    }
  }
}

void BagScanner::take(const node::Taken& taken, std::chrono::nanoseconds end,
                      std::chrono::nanoseconds received, node::ScanCollector& collector,
                      tf2::BufferCore& transforms) const {
  for (const auto& transform : taken.transforms) {
    const auto problem = node::addTransform(transform, false, received, transforms);
    if (problem) collector.noteProblem("odometry", *problem);
  }
  for (const node::CheckedHeading& heading : taken.headings) {
    // Without odometry those after the end serve readings that still wait for the next heading.
    const bool serves = parameters_.odom_frame.empty() && collector.waiting();
    if (heading.stamp <= end || serves) collector.addHeading(heading, received);
  }
  for (const node::AdaptedReading& reading : taken.readings) {
    if (reading.measurement.stamp <= end) collector.addReading(reading, received);
  }
  for (const node::Taken::Problem& problem : taken.problems) {
    collector.noteProblem(problem.input, problem.sentence);
  }
}

node::ScanOutcome BagScanner::scan(const ros::Time& start, const ros::Time& end) {
  const ros::Duration wait(parameters_.scan.tf_timeout);
  tf2::BufferCore transforms(end - start + kLead + kLead);
  for (const auto& transform : static_transforms_) {
    node::addTransform(transform, true, node::toNanoseconds(start), transforms);
  }
  node::ScanCollector collector(parameters_, transforms, registry_);
  collector.begin(node::toNanoseconds(start), parameters_.scan.headings, parameters_.scan.step);

  const ros::Time first = start.toSec() > kLead.toSec() ? start - kLead : ros::TIME_MIN;
  rosbag::View view(bag_, rosbag::TopicQuery(topics_), first, end + wait + kRecordingDelay);
  for (const rosbag::MessageInstance& message : view) {
    const std::string topic = withoutSlash(message.getTopic());
    const auto received = node::toNanoseconds(message.getTime());
    if (topic == kTf) {
      const auto moved = message.instantiate<tf2_msgs::TFMessage>();
      if (!moved) continue;
      for (const auto& transform : moved->transforms) {
        const auto problem = node::addTransform(transform, false, received, transforms);
        if (problem) collector.noteProblem("tf", *problem);
      }
    } else {
      const node::Taken taken =
          intake_.take(topic, node::readMessage(message), received, transforms);
      take(taken, node::toNanoseconds(end), received, collector, transforms);
      if (!taken.readings.empty()) continue;  // what they need comes later
    }
    collector.process(received);
  }
  collector.process(node::toNanoseconds(ros::TIME_MAX));
  return collector.outcome(node::toNanoseconds(end));
}

}  // namespace place_memory::tools
