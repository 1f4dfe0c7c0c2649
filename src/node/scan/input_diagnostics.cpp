#include "node/scan/input_diagnostics.h"

#include <boost/algorithm/string/join.hpp>
#include <iomanip>
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
  }
}

std::string rate(std::uint32_t messages) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1)
       << static_cast<double>(messages) / static_cast<double>(core::RecentCount::kSeconds) << " Hz";
  return text.str();
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
  status.add("age of odometry", inSeconds(age));
  if (age > toNanoseconds(parameters.scan.heading_timeout)) {
    status.mergeSummary(Level::WARN, "the newest transform from " + way + " is " + inSeconds(age) +
                                         " old: does what publishes odometry still run, and is its "
                                         "clock right?");
  }
}

}  // namespace

void diagnoseSonars(const InputHealth& health, Status& status) {
  status.summary(Level::OK, std::to_string(health.sensors.size()) + " sensors");
  if (health.sensors.empty()) {
    status.summary(Level::WARN, "no sensor has sent a reading: is anything published on " +
                                    boost::algorithm::join(health.sonar_topics, ", ") + "?");
  }
  for (const std::string& sentence : health.wrong_types) {
    status.mergeSummary(Level::ERROR, sentence);
  }
  for (const SensorHealth& sensor : health.sensors) {
    summarize(sensor, status);
    const std::string rejected = inWords(sensor.rejected);
    status.add(sensor.name, std::to_string(sensor.messages) + " messages in 10 s" +
                                (rejected.empty() ? "" : ", " + rejected));
  }
}

void diagnoseCompass(const InputHealth& health, Status& status) {
  const CompassHealth& compass = health.compass;
  const std::string topic = health.heading_topic;
  if (topic.empty()) {
    status.summary(Level::OK, "there is none (heading_topic): scans lie by odometry's yaw");
    return;
  }
  status.summary(Level::OK, "headings at " + rate(compass.messages));
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
  status.add("topic", topic);
  status.add("rate", rate(compass.messages));
  status.add("left out in 10 s", compass.left_out);
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
    if (lookupNewest(buffer, parameters.base_frame, frame, stamp)) continue;
    status.mergeSummary(Level::WARN, "no transform from " + frame + " to " + parameters.base_frame +
                                         ": " + adviceOn(Reject::kNoTransform));
  }
  if (left_out.transforms > 0) status.mergeSummary(Level::WARN, left_out.newest);
  status.add("left out in 10 s", left_out.transforms);
}

}  // namespace place_memory::node
