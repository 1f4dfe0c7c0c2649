#include "tools/bag_scanner.h"

#include <tf2_msgs/TFMessage.h>

#include <boost/algorithm/string/join.hpp>
#include <stdexcept>

#include "node/base/ros_time.h"
#include "node/input/input_message.h"
#include "node/input/transform_filter.h"

namespace place_memory::tools {
namespace {

constexpr char kTf[] = "tf";
constexpr char kStaticTf[] = "tf_static";

// Transforms and headings so long before a scan are read too: between two of them lies its start;
// and so long after what still waits has to be there.
constexpr double kLead = 10.0;
constexpr double kTrail = 1.0;

/// As node::readMessage() reads messages.
struct Source {
  const StoredMessage& stored;

  const std::string& getDataType() const { return stored.type; }
  template <class Content>
  boost::shared_ptr<Content> instantiate() const {
    const auto content = stored.as<Content>();
    return content ? boost::make_shared<Content>(*content) : nullptr;
  }
};

/// What messages are given to for one scan.
struct Inputs {
  const config::Parameters& parameters;
  tf2::BufferCore& transforms;
  BagScanner& scanner;
  node::ScanCollector& collector;
  std::chrono::nanoseconds end;

  void addTransforms(const TimedMessage& timed) {
    const auto moved = timed.message->as<tf2_msgs::TFMessage>();
    if (!moved) return;
    for (const auto& transform : moved->transforms) {
      const auto problem =
          node::addTransform(transform, false, node::toNanoseconds(timed.time), transforms);
      if (problem) collector.noteProblem(kTf, *problem);
    }
  }

  /// Whether readings came, which wait for what comes later.
  bool addInput(const TimedMessage& timed) {
    const auto received = node::toNanoseconds(timed.time);
    const node::Taken taken = scanner.take(timed, transforms);
    for (const auto& transform : taken.transforms) {
      const auto problem = node::addTransform(transform, false, received, transforms);
      if (problem) collector.noteProblem("odometry", *problem);
    }
    for (const node::CheckedHeading& heading : taken.headings) {
      // Without odometry those after the end serve readings that still wait for the next heading.
      const bool serves = parameters.odom_frame.empty() && collector.waiting();
      if (heading.stamp <= end || serves) collector.addHeading(heading, received);
    }
    for (const node::AdaptedReading& reading : taken.readings) {
      if (reading.measurement.stamp <= end) collector.addReading(reading, received);
    }
    for (const node::Taken::Problem& problem : taken.problems) {
      collector.noteProblem(problem.input, problem.sentence);
    }
    return !taken.readings.empty();
  }
};

}  // namespace

BagScanner::BagScanner(const BagSet& bags, const config::Parameters& parameters)
    : bags_(bags), parameters_(parameters), intake_(parameters, withoutSlash, registry_) {
  for (const auto& [topic, role] : intake_.topics()) {
    std::string wrong;
    for (const std::string& type : require(topic)) {
      wrong = node::wrongType(topic, role, type);
      if (wrong.empty()) break;
    }
    if (!wrong.empty()) throw std::runtime_error("in " + bags_.name() + " " + wrong);
    topics_.insert(topic);
  }
  if (!parameters.odom_frame.empty() && parameters.odom_topic.empty()) require(kTf);
  topics_.insert(kTf);
  readStaticTransforms();
}

const std::set<std::string>& BagScanner::require(const std::string& topic) const {
  const auto found = bags_.types().find(topic);
  if (found != bags_.types().end()) return found->second;
  std::vector<std::string> others;
  for (const auto& [other, its_types] : bags_.types()) others.push_back(other);
  throw std::runtime_error(bags_.name() + (bags_.isOne() ? " has" : " have") + " no topic " +
                           topic + "; there are " + boost::algorithm::join(others, ", "));
}

void BagScanner::readStaticTransforms() {
  bags_.readAll(kStaticTf, [this](const TimedMessage& timed) {
    if (const auto transforms = timed.message->as<tf2_msgs::TFMessage>()) {
      static_transforms_.insert(static_transforms_.end(), transforms->transforms.begin(),
                                transforms->transforms.end());
    }
  });
}

node::Taken BagScanner::take(const TimedMessage& timed, const tf2::BufferCore& transforms) {
  return intake_.take(timed.message->topic, node::readMessage(Source{*timed.message}),
                      node::toNanoseconds(timed.time), transforms);
}

BagScan BagScanner::scan(const ros::Time& start, const ros::Time& end) {
  tf2::BufferCore transforms(end - start + ros::Duration(2.0 * kLead));
  for (const auto& transform : static_transforms_) {
    node::addTransform(transform, true, node::toNanoseconds(start), transforms);
  }
  node::ScanCollector collector(parameters_, transforms, registry_);
  collector.begin(node::toNanoseconds(start), parameters_.scan.headings, parameters_.scan.step);

  Inputs inputs{parameters_, transforms, *this, collector, node::toNanoseconds(end)};
  const ros::Time last = later(end, parameters_.scan.tf_timeout + kTrail);
  bags_.read(topics_, later(start, -kLead), last, [&](const TimedMessage& timed) {
    if (timed.message->topic == kTf) {
      inputs.addTransforms(timed);
    } else if (inputs.addInput(timed)) {
      return;
    }
    collector.process(node::toNanoseconds(timed.time));
  });
  collector.process(node::toNanoseconds(ros::TIME_MAX));
  return {collector.outcome(node::toNanoseconds(end)), node::inWords(collector.rejected())};
}

}  // namespace place_memory::tools
