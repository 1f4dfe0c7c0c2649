#include "node/scan/input_diagnostics.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <iomanip>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "node/base/ros_time.h"
#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;
using Status = diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kNearlyAll = 0.9;  // of a sensor's readings

std::uint32_t count(const SensorHealth& sensor, Reject reject) {
  return sensor.rejected.at(static_cast<std::size_t>(reject));
}

void summarize(const SensorHealth& sensor, Status& status) {
  const auto warn = [&](const std::string& text) {
    status.mergeSummary(Level::WARN, sensor.name + ": " + text);
  };
  const auto rejected =
      std::accumulate(sensor.rejected.begin(), sensor.rejected.end(), std::uint32_t{0});
  if (sensor.silent > kSensorSilence) {
    warn("silent for " + inSeconds(sensor.silent) +
         ": is it plugged in, and its driver running? (" + sensor.topic + ")");
  } else if (!sensor.sensor_problem.empty()) {
    status.mergeSummary(Level::ERROR, sensor.name + ": " + sensor.sensor_problem);
  } else if (rejected > 0 && rejected >= kNearlyAll * sensor.messages) {
    const Reject reason = mostFrequent(sensor.rejected);
    warn("readings are rejected (" + inWords(sensor.rejected) + " of " +
         std::to_string(sensor.messages) + " in the last 10 s): " + adviceOn(reason));
  } else if (count(sensor, Reject::kOld) > 0) {
    warn(std::to_string(count(sensor, Reject::kOld)) +
         " readings of the last 10 s are left out by their stamp: " + adviceOn(Reject::kOld));
  } else if (!sensor.unit_problem.empty()) {
    status.mergeSummary(Level::WARN, sensor.unit_problem);
  }
}

/// A number for programs that draw it; its unit stands in the key.
std::string number(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

std::string hertz(std::uint32_t messages) {
  return number(static_cast<double>(messages) / static_cast<double>(core::RecentCount::kSeconds));
}

void diagnoseOdometry(const tf2::BufferCore& buffer, const config::Parameters& parameters,
                      std::chrono::nanoseconds now, Status& status) {
  const std::string way = parameters.base_frame + " to " + parameters.odom_frame;
  std::chrono::nanoseconds stamp{0};
  if (!lookupNewest(buffer, parameters.odom_frame, parameters.base_frame, stamp)) {
    status.mergeSummary(Level::WARN,
                        "no transform from " + way +
                            ": start what publishes odometry, or correct odom_frame and base_frame "
                            "(odom_frame \"\": there is no odometry)");
    return;
  }
  const std::chrono::nanoseconds age = now - stamp;
  status.add("age of odometry [s]", number(std::chrono::duration<double>(age).count()));
  if (age > toNanoseconds(parameters.scan.heading_timeout)) {
    status.mergeSummary(Level::WARN, "the newest transform from " + way + " is " + inSeconds(age) +
                                         " old: does what publishes odometry still run, and is its "
                                         "clock right?");
  }
}

// Sensors that speak lately, but cannot be told apart by their frames, or from the robot.
void diagnoseFrames(const InputHealth& health, const std::string& base_frame, Status& status) {
  std::map<std::string, std::set<std::string>> topics;
  for (const SensorHealth& sensor : health.sensors) {
    if (sensor.silent > kSensorSilence || sensor.frame.empty() || sensor.is_of_ring) continue;
    topics[sensor.frame].insert(sensor.topic);
  }
  for (const auto& [frame, on] : topics) {
    const std::string sensors = "sensors on " + boost::algorithm::join(on, ", ");
    if (frame == base_frame) {
      status.mergeSummary(Level::WARN, sensors + " have the frame of the robot itself, " + frame +
                                           ": give each one of its own");
    } else if (on.size() > 1) {
      status.mergeSummary(Level::WARN,
                          sensors + " have the same frame " + frame + ": give each one of its own");
    }
  }
}

}  // namespace

std::string silentTopics(const InputHealth& health) {
  std::vector<std::string> silent;
  for (const std::string& topic : health.sonar_topics) {
    const bool speaks = std::any_of(
        health.sensors.begin(), health.sensors.end(),
        [&](const SensorHealth& s) { return s.topic == topic || s.id == kOtherSensors; });
    const bool is_named =
        std::any_of(health.wrong_types.begin(), health.wrong_types.end(),
                    [&](const std::string& s) { return s.find(topic) != std::string::npos; });
    if (!speaks && !is_named) silent.push_back(topic);
  }
  if (silent.empty() || health.sensors.empty()) return {};
  return "nothing has come on " + boost::algorithm::join(silent, ", ") +
         " (sonar_topics): is the sensor plugged in, and the name right?";
}

void diagnoseSonars(const InputHealth& health, Status& status) {
  status.summary(Level::OK, std::to_string(health.sensors.size()) + " sensors");
  if (health.sensors.empty()) {
    status.summary(Level::WARN, "no sensor has sent a reading: is anything published on " +
                                    boost::algorithm::join(health.sonar_topics, ", ") + "?");
  }
  for (const std::string& sentence : health.wrong_types) {
    status.mergeSummary(Level::ERROR, sentence);
  }
  const std::string silent = silentTopics(health);
  if (!silent.empty()) status.mergeSummary(Level::WARN, silent);
  for (const SensorHealth& sensor : health.sensors) {
    summarize(sensor, status);
    status.add(sensor.name + " readings [Hz]", hertz(sensor.messages));
    for (std::size_t i = 0; i < sensor.rejected.size(); ++i) {
      if (sensor.rejected[i] == 0) continue;
      status.add(sensor.name + " left out [Hz]: " + toString(static_cast<Reject>(i)),
                 hertz(sensor.rejected[i]));
    }
  }
}

void diagnoseCompass(const InputHealth& health, Status& status) {
  const CompassHealth& compass = health.compass;
  const std::string topic = health.heading_topic;
  if (topic.empty()) {
    status.summary(Level::OK, "there is none (heading_topic): scans lie by odometry's yaw");
    return;
  }
  status.summary(Level::OK, "headings at " + hertz(compass.messages) + " Hz");
  if (!compass.heard) {
    status.summary(Level::WARN, "no heading has come: is anything published on " + topic +
                                    "? every scan needs one");
  } else if (compass.silent > kSensorSilence) {
    status.summary(Level::WARN, "silent for " + inSeconds(compass.silent) +
                                    ": is the compass plugged in, and its driver running? (" +
                                    topic + ")");
  } else if (compass.left_out > 0) {
    status.summary(Level::WARN, std::to_string(compass.left_out) + " of " +
                                    std::to_string(compass.messages) +
                                    " headings of the last 10 s are left out: " + compass.problem);
  }
  if (!compass.doubt.empty()) status.mergeSummary(Level::WARN, compass.doubt);
  status.add("topic", topic);
  status.add("headings [Hz]", hertz(compass.messages));
  status.add("left out [Hz]", hertz(compass.left_out));
}

void diagnoseTransforms(const tf2::BufferCore& buffer, const TransformInput::LeftOut& left_out,
                        const InputHealth& health, const config::Parameters& parameters,
                        std::chrono::nanoseconds now, Status& status) {
  status.summary(Level::OK, "every frame is known");
  if (!parameters.odom_frame.empty()) diagnoseOdometry(buffer, parameters, now, status);
  std::set<std::string> frames;
  for (const SensorHealth& sensor : health.sensors) {
    if (sensor.silent <= kSensorSilence && !sensor.frame.empty()) frames.insert(sensor.frame);
  }
  for (const std::string& frame : frames) {
    std::chrono::nanoseconds stamp{0};
    if (lookupNewest(buffer, parameters.base_frame, frame, stamp)) {
      const std::chrono::nanoseconds age = now - stamp;
      if (stamp.count() == 0 || age <= kSensorSilence) continue;  // 0: it holds for ever
      status.mergeSummary(Level::WARN, "the newest transform from " + frame + " is " +
                                           inSeconds(age) +
                                           " old: does what publishes it still run?");
      continue;
    }
    status.mergeSummary(Level::WARN, "no transform from " + frame + " to " + parameters.base_frame +
                                         ": " + adviceOn(Reject::kNoTransform));
  }
  diagnoseFrames(health, parameters.base_frame, status);
  if (left_out.transforms > 0) status.mergeSummary(Level::WARN, left_out.newest);
  status.add("left out [Hz]", hertz(left_out.transforms));
}

}  // namespace place_memory::node
