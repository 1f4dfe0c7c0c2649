#include "tools/bag_scanner.h"

#include <sensor_msgs/Imu.h>
#include <sensor_msgs/Range.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/algorithm/string/join.hpp>
#include <stdexcept>

#include "node/base/ros_time.h"
#include "node/input/range_adapter.h"
#include "node/input/transform_filter.h"

namespace place_memory::tools {
namespace {

constexpr char kTf[] = "tf";
constexpr char kStaticTf[] = "tf_static";

// Transforms and headings so long before a scan are read too: between two of them lies its start;
// and so long after what still waits has to be there.
constexpr double kLead = 10.0;
constexpr double kTrail = 1.0;

/// What messages are given to for one scan.
struct Inputs {
  const config::Parameters& parameters;
  tf2::BufferCore& transforms;
  node::SensorRegistry& registry;
  node::ScanCollector& collector;
  ros::Time end;

  void addTransforms(const TimedMessage& timed) {
    const auto moved = timed.message->as<tf2_msgs::TFMessage>();
    if (!moved) return;
    for (const auto& transform : moved->transforms) {
      const auto problem =
          node::addTransform(transform, false, node::toNanoseconds(timed.time), transforms);
      if (problem) collector.noteProblem(kTf, *problem);
    }
  }

  void addHeading(const TimedMessage& timed) {
    // Without odometry those after the end serve readings that still wait for the next heading.
    const bool serves = parameters.odom_frame.empty() && collector.waiting();
    const auto heading = timed.message->as<sensor_msgs::Imu>();
    if (!heading || (heading->header.stamp > end && !serves)) return;
    collector.addHeading(*heading, node::toNanoseconds(timed.time));
  }

  void addReading(const TimedMessage& timed) {
    const auto range = timed.message->as<sensor_msgs::Range>();
    if (!range || range->header.stamp > end) return;
    const node::RangeAdapter adapter("/" + timed.message->topic,
                                     parameters.scan.over_range_is_no_echo, registry);
    collector.addReading(adapter.adapt(*range), node::toNanoseconds(timed.time));
  }
};

}  // namespace

BagScanner::BagScanner(const BagSet& bags, const config::Parameters& parameters)
    : bags_(bags), parameters_(parameters) {
  for (const std::string& topic : parameters.sonar_topics) {
    topics_.insert(require(topic, {"sensor_msgs/Range"}));
  }
  heading_topic_ = require(parameters.heading_topic, {"sensor_msgs/Imu"});
  topics_.insert(heading_topic_);
  const std::set<std::string> transforms = {"tf2_msgs/TFMessage", "tf/tfMessage"};
  if (!parameters.odom_frame.empty()) require(kTf, transforms);
  topics_.insert(kTf);
  readStaticTransforms();
}

std::string BagScanner::require(const std::string& topic,
                                const std::set<std::string>& types) const {
  const std::string name = withoutSlash(topic);
  const auto found = bags_.types().find(name);
  if (found == bags_.types().end()) {
    std::vector<std::string> others;
    for (const auto& [other, its_types] : bags_.types()) others.push_back(other);
    throw std::runtime_error(bags_.name() + (bags_.isOne() ? " has" : " have") + " no topic " +
                             topic + "; there are " + boost::algorithm::join(others, ", "));
  }
  for (const std::string& type : found->second) {
    if (types.count(type) > 0) return name;
  }
  throw std::runtime_error("in " + bags_.name() + " the topic " + topic + " holds " +
                           boost::algorithm::join(found->second, " and ") + ", not " +
                           *types.rbegin());
}

void BagScanner::readStaticTransforms() {
  bags_.readAll(kStaticTf, [this](const TimedMessage& timed) {
    if (const auto transforms = timed.message->as<tf2_msgs::TFMessage>()) {
      static_transforms_.insert(static_transforms_.end(), transforms->transforms.begin(),
                                transforms->transforms.end());
    }
  });
}

BagScan BagScanner::scan(const ros::Time& start, const ros::Time& end) const {
  tf2::BufferCore transforms(end - start + ros::Duration(2.0 * kLead));
  for (const auto& transform : static_transforms_) {
    node::addTransform(transform, true, node::toNanoseconds(start), transforms);
  }
  node::SensorRegistry registry;
  node::ScanCollector collector(parameters_, transforms, registry);
  collector.begin(node::toNanoseconds(start), parameters_.scan.headings, parameters_.scan.step);

  Inputs inputs{parameters_, transforms, registry, collector, end};
  const ros::Time last = later(end, parameters_.scan.tf_timeout + kTrail);
  bags_.read(topics_, later(start, -kLead), last, [&](const TimedMessage& timed) {
    const std::string& topic = timed.message->topic;
    if (topic != kTf && topic != heading_topic_) {
      inputs.addReading(timed);
      return;  // what it needs comes later
    }
    topic == kTf ? inputs.addTransforms(timed) : inputs.addHeading(timed);
    collector.process(node::toNanoseconds(timed.time));
  });
  collector.process(node::toNanoseconds(ros::TIME_MAX));
  return {collector.outcome(node::toNanoseconds(end)), node::inWords(collector.rejected())};
}

}  // namespace place_memory::tools
