#ifndef PLACE_MEMORY_NODE_INPUT_MESSAGE_INTAKE_H
#define PLACE_MEMORY_NODE_INPUT_MESSAGE_INTAKE_H

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/input/adapted_reading.h"
#include "node/input/cloud_adapter.h"
#include "node/input/heading_adapter.h"
#include "node/input/heading_check.h"
#include "node/input/input_message.h"
#include "node/input/laser_adapter.h"
#include "node/input/range_adapter.h"
#include "node/input/sensor_registry.h"
#include "node/input/shared_frame_watch.h"
#include "node/input/unit_watch.h"

namespace place_memory::node {

/// What a topic is listened to for.
enum class InputRole { kSonar, kHeading, kOdometry };

/// The types that a topic may carry, as "sensor_msgs/Range".
std::vector<std::string> typesOf(InputRole role);

/// That a topic carries a type that is none of those, in a sentence; empty: it is one of them.
std::string wrongType(const std::string& topic, InputRole role, const std::string& type);

/// What a message says.
struct Taken {
  struct Problem {
    std::string input;  ///< to which it belongs; a newer one of the same input takes its place
    std::string sentence;
  };

  std::vector<AdaptedReading> readings;
  std::vector<CheckedHeading> headings;
  std::vector<geometry_msgs::TransformStamped> transforms;  ///< odometry, not checked yet
  std::vector<Problem> problems;
};

/// Takes messages of every type on the topics that the parameters name: node and bag tool alike.
/// What it finds out on the way, as which value a driver has for no echo, depends on the messages
/// and their order alone. Never throws for what a message holds. Not thread-safe.
class MessageIntake {
 public:
  /// Both must outlive it. `resolve` makes of a parameter's topic what take() will be given. Throws
  /// std::invalid_argument where one topic is to carry sonar, headings or odometry at once.
  MessageIntake(const config::Parameters& parameters,
                const std::function<std::string(const std::string&)>& resolve,
                SensorRegistry& registry);

  /// Every topic to listen to, resolved.
  const std::map<std::string, InputRole>& topics() const { return topics_; }

  /// `received`: when it came. `transforms`: in which the frame of a compass is looked up.
  Taken take(const std::string& topic, const InputMessage& message,
             std::chrono::nanoseconds received, const tf2::BufferCore& transforms);

  /// A sentence for each topic whose newest message was of a wrong type.
  std::vector<std::string> wrongTypes() const;

 private:
  void takeSonar(const std::string& topic, const InputMessage& message, Taken& taken);
  void takeHeading(const InputMessage& message, std::chrono::nanoseconds received,
                   const tf2::BufferCore& transforms, Taken& taken);
  void takeOdometry(const std::string& topic, const nav_msgs::Odometry& message, Taken& taken);
  void watchFrame(const std::string& topic, const std::string& frame, Taken& taken);
  void watchSharing(const std::string& topic, const sensor_msgs::Range& message,
                    const core::Measurement& measurement, Taken& taken);
  void watchUnits(AdaptedReading& reading, Taken& taken);
  void once(const std::string& input, const std::string& sentence, Taken& taken);

  const config::Parameters& parameters_;
  SensorRegistry& registry_;
  std::map<std::string, InputRole> topics_;
  std::map<std::string, RangeAdapter> ranges_;
  std::map<std::string, CloudAdapter> clouds_;
  std::map<std::string, LaserAdapter> lasers_;
  HeadingAdapter heading_;
  SharedFrameWatch shared_;
  UnitWatch units_;
  std::map<std::string, std::string> wrong_types_;     // by topic
  std::map<std::string, std::string> topic_of_frame_;  // bounded by the registry's sensors
  std::set<std::string> said_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_MESSAGE_INTAKE_H
