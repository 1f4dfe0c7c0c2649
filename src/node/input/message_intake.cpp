#include "node/input/message_intake.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <sstream>
#include <stdexcept>

#include "node/input/frame_name.h"

namespace place_memory::node {
namespace {

// Sentences that are said once; there are not so many but by ever new frames.
constexpr std::size_t kMostSaid = 1000;

std::string inWords(const NoEchoWord& word, const std::string& name) {
  std::ostringstream text;
  text << name << " says " << word.range << " m, " << word.kind << ": taken as no echo ("
       << (word.range > 0.0 ? "sonar/top_is_no_echo" : "sonar/zero_is_no_echo")
       << ": false changes that)";
  return text.str();
}

const char* parameterOf(InputRole role) {
  return role == InputRole::kSonar     ? "sonar_topics"
         : role == InputRole::kHeading ? "heading_topic"
                                       : "odom_topic";
}

// Of a range outside the limits that comes again and again, and is left out.
std::string repeatedInWords(double range, const core::Measurement& measurement,
                            const std::string& name) {
  const bool is_below = range < measurement.spec.min_range;
  std::ostringstream text;
  text << name << " says " << range << " m again and again, "
       << (is_below ? "below its min_range of " : "beyond its max_range of ")
       << (is_below ? measurement.spec.min_range : measurement.spec.max_range)
       << " m, and is left out: if that is its driver's word for no echo, ";
  if (range < 0.0) {
    text << "sonar/zero_is_no_echo: true takes it as that";
  } else if (range == 0.0) {
    text << "scan/zero_range_is_no_echo: true takes it as that; if not, is the sensor covered?";
  } else if (is_below) {
    text << "let it say +inf; if not, is the sensor covered?";
  } else {
    text << "scan/over_range_is_no_echo: true takes it as that; if not, are its ranges in metres?";
  }
  return text.str();
}

}  // namespace

std::vector<std::string> typesOf(InputRole role) {
  switch (role) {
    case InputRole::kSonar:
      return {"sensor_msgs/Range", "sensor_msgs/PointCloud", "sensor_msgs/PointCloud2",
              "sensor_msgs/LaserScan"};
    case InputRole::kHeading:
      return {"sensor_msgs/Imu", "sensor_msgs/MagneticField", "std_msgs/Float64"};
    case InputRole::kOdometry:
      return {"nav_msgs/Odometry"};
  }
  return {};
}

std::string wrongType(const std::string& topic, InputRole role, const std::string& type) {
  const std::vector<std::string> types = typesOf(role);
  if (std::find(types.begin(), types.end(), type) != types.end()) return {};
  return "the topic " + topic + " (" + parameterOf(role) + ") carries " + type + ", needed is " +
         boost::algorithm::join(types, " or ");
}

MessageIntake::MessageIntake(const config::Parameters& parameters,
                             const std::function<std::string(const std::string&)>& resolve,
                             SensorRegistry& registry)
    : parameters_(parameters),
      registry_(registry),
      heading_(parameters),
      units_(parameters.grid.halfWidth()) {
  for (const std::string& name : parameters.sonar_topics) {
    const std::string topic = resolve(name);
    topics_.emplace(topic, InputRole::kSonar);
    ranges_.emplace(topic, RangeAdapter(topic, parameters, registry));
    clouds_.emplace(topic, CloudAdapter(topic, parameters, registry));
    lasers_.emplace(topic, LaserAdapter(topic, parameters, registry));
  }
  const auto add = [&](const std::string& name, InputRole role) {
    if (name.empty()) return;
    const auto [known, is_new] = topics_.emplace(resolve(name), role);
    if (is_new) return;
    throw std::invalid_argument(std::string(parameterOf(role)) + " and " +
                                parameterOf(known->second) + " are the same topic, " +
                                known->first +
                                ": it carries one of the two; see to the other's "
                                "name, or to what it is remapped to");
  };
  add(parameters.heading_topic, InputRole::kHeading);
  add(parameters.odom_topic, InputRole::kOdometry);
}

Taken MessageIntake::take(const std::string& topic, const InputMessage& message,
                          std::chrono::nanoseconds received, const tf2::BufferCore& transforms) {
  Taken taken;
  const auto known = topics_.find(topic);
  if (known == topics_.end()) return taken;
  const InputRole role = known->second;
  std::string problem = wrongType(topic, role, message.type);
  if (problem.empty() && !message.problem.empty()) {
    problem = "message on " + topic + " left out: " + message.problem;
  }
  if (!problem.empty()) {
    wrong_types_[topic] = problem;
    taken.problems.push_back({topic, problem});
    return taken;
  }
  wrong_types_.erase(topic);
  if (role == InputRole::kSonar) {
    takeSonar(topic, message, taken);
  } else if (role == InputRole::kHeading) {
    takeHeading(message, received, transforms, taken);
  } else if (const auto* odometry = std::get_if<nav_msgs::Odometry::ConstPtr>(&message.content)) {
    takeOdometry(topic, **odometry, taken);
  }
  return taken;
}

std::vector<std::string> MessageIntake::wrongTypes() const {
  std::vector<std::string> sentences;
  for (const auto& [topic, sentence] : wrong_types_) sentences.push_back(sentence);
  return sentences;
}

void MessageIntake::takeSonar(const std::string& topic, const InputMessage& message, Taken& taken) {
  if (const auto* range = std::get_if<sensor_msgs::Range::ConstPtr>(&message.content)) {
    taken.readings = {ranges_.at(topic).adapt(**range)};
    watchFrame(topic, taken.readings.front().measurement.frame, taken);
    watchSharing(topic, **range, taken.readings.front().measurement, taken);
  } else if (const auto* cloud = std::get_if<sensor_msgs::PointCloud::ConstPtr>(&message.content)) {
    taken.readings = clouds_.at(topic).adapt(**cloud);
  } else if (const auto* cloud2 =
                 std::get_if<sensor_msgs::PointCloud2::ConstPtr>(&message.content)) {
    taken.readings = clouds_.at(topic).adapt(**cloud2);
  } else if (const auto* scan = std::get_if<sensor_msgs::LaserScan::ConstPtr>(&message.content)) {
    taken.readings = lasers_.at(topic).adapt(**scan);
    watchFrame(topic, taken.readings.front().measurement.frame, taken);
  }
  for (AdaptedReading& reading : taken.readings) {
    if (!reading.sensor_problem.empty()) {
      const std::string name = registry_.nameOf(reading.measurement.sensor);
      const std::string where = name.find(topic) == std::string::npos ? " on " + topic : "";
      taken.problems.push_back(
          {name, "readings of " + name + where + " are left out: " + reading.sensor_problem});
    }
    if (reading.no_echo) {
      // One word for all sensors of a topic that say it so.
      const std::string input = topic + " " + reading.no_echo->kind;
      if (said_.count(input) == 0) {
        once(input, inWords(*reading.no_echo, registry_.nameOf(reading.measurement.sensor)), taken);
      }
    }
    if (reading.repeated) {
      const std::string name = registry_.nameOf(reading.measurement.sensor);
      taken.problems.push_back(
          {name, repeatedInWords(*reading.repeated, reading.measurement, name)});
    }
    watchUnits(reading, taken);
  }
}

void MessageIntake::takeHeading(const InputMessage& message, std::chrono::nanoseconds received,
                                const tf2::BufferCore& transforms, Taken& taken) {
  if (const auto* imu = std::get_if<sensor_msgs::Imu::ConstPtr>(&message.content)) {
    taken.headings = {heading_.adapt(**imu, transforms)};
  } else if (const auto* field =
                 std::get_if<sensor_msgs::MagneticField::ConstPtr>(&message.content)) {
    taken.headings = {heading_.adapt(**field, transforms)};
  } else if (const auto* bearing = std::get_if<std_msgs::Float64::ConstPtr>(&message.content)) {
    taken.headings = {heading_.adapt(**bearing, received)};
  }
  if (!heading_.frameProblem().empty()) {
    once("frame of the compass", heading_.frameProblem(), taken);
  }
}

void MessageIntake::takeOdometry(const std::string& topic, const nav_msgs::Odometry& message,
                                 Taken& taken) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = message.header.stamp;
  transform.header.frame_id = parameters_.odom_frame;
  transform.child_frame_id = parameters_.base_frame;
  transform.transform.translation.x = message.pose.pose.position.x;
  transform.transform.translation.y = message.pose.pose.position.y;
  transform.transform.translation.z = message.pose.pose.position.z;
  transform.transform.rotation = message.pose.pose.orientation;
  taken.transforms.push_back(transform);
  std::string ignored;
  const std::string odom = frameName(message.header.frame_id, ignored);
  const std::string base = frameName(message.child_frame_id, ignored);
  const bool is_other = (!odom.empty() && odom != parameters_.odom_frame) ||
                        (!base.empty() && base != parameters_.base_frame);
  if (!is_other) return;
  once("frames of " + topic,
       "odometry on " + topic + " says it is from " + odom + " to " + base +
           "; it is taken as from " + parameters_.odom_frame + " to " + parameters_.base_frame +
           " (odom_frame, base_frame)",
       taken);
}

void MessageIntake::watchFrame(const std::string& topic, const std::string& frame, Taken& taken) {
  if (frame.empty()) return;
  if (frame == parameters_.base_frame) {
    once("frame on " + topic,
         "a sensor on " + topic + " has the frame of the robot itself, " + frame +
             ": its readings are taken as from the robot's middle, ahead; give each sensor a frame "
             "of its own, and publish on tf where it is mounted",
         taken);
    return;
  }
  if (topic_of_frame_.size() > SensorRegistry::kMaxSensors) return;
  const std::string& first = topic_of_frame_.emplace(frame, topic).first->second;
  if (first == topic) return;
  once("frame " + frame,
       "sensors on " + first + " and " + topic + " have the same frame " + frame +
           ": their readings are taken as from one spot; give each sensor a frame of its own, and "
           "publish on tf where it is mounted",
       taken);
}

void MessageIntake::watchSharing(const std::string& topic, const sensor_msgs::Range& message,
                                 const core::Measurement& measurement, Taken& taken) {
  // Both are said elsewhere.
  if (measurement.frame.empty() || message.header.stamp.isZero()) return;
  const auto stamp = std::chrono::nanoseconds(message.header.stamp.toNSec());
  if (!shared_.note(measurement.sensor, stamp, message.range)) return;
  once("frame shared on " + topic + " " + measurement.frame,
       "several readings of one stamp come on " + topic + " with the one frame " +
           measurement.frame +
           ", as from several sensors: they are taken as from one spot; give each sensor a frame "
           "of its own, and publish on tf where it is mounted",
       taken);
}

void MessageIntake::watchUnits(AdaptedReading& reading, Taken& taken) {
  reading.unit_problem = units_.note(reading, registry_);
  if (reading.unit_problem.empty()) return;
  once("units of " + registry_.nameOf(reading.measurement.sensor), reading.unit_problem, taken);
}

void MessageIntake::once(const std::string& input, const std::string& sentence, Taken& taken) {
  if (said_.size() >= kMostSaid || !said_.insert(input).second) return;
  taken.problems.push_back({input, sentence});
}

}  // namespace place_memory::node
