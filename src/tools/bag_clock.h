#ifndef PLACE_MEMORY_TOOLS_BAG_CLOCK_H
#define PLACE_MEMORY_TOOLS_BAG_CLOCK_H

#include <ros/time.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "tools/quantile_sample.h"
#include "tools/stored_message.h"

namespace place_memory::tools {

/// `time` and so many seconds, within what ros::Time can hold.
ros::Time later(const ros::Time& time, double seconds);

/// One publisher's clock is told from another's by topic and frame.
using InputName = std::pair<std::string, std::string>;

/// How the clock of the recorder stands to that of the robot, by which messages are stamped.
struct BagClock {
  double offset = 0.0;    ///< recorder ahead of the robot [s]; one too small to matter is 0
  double lateness = 0.0;  ///< messages were recorded up to so long after their stamps [s]
  ros::Time first;        ///< header stamps in the bag, of those that can be right
  ros::Time last;
  std::map<InputName, double> strays;  ///< inputs stamped so long before the others [s]

  /// When a message came, by the robot's clock.
  ros::Time received(const ros::Time& recorded) const { return later(recorded, -offset); }
  /// Whether a stamp can be right.
  bool credible(const ros::Time& stamp, const ros::Time& recorded) const;
  bool isStray(const StoredMessage& message, const Origin& origin) const {
    return strays.count({message.topic, origin.frame}) > 0;
  }
};

/// Measures it from every message of a bag, in bounded memory.
class ClockMeasurement {
 public:
  /// `rules`: whether the message is of the inputs that are read. Others tell alone when the bag
  /// begins.
  void note(const StoredMessage& message, const Origin& origin, bool rules);
  /// When any message was recorded.
  void note(const ros::Time& recorded);

  BagClock clock() const;

 private:
  struct Span {
    ros::Time first;
    ros::Time last;
  };

  struct Input {
    QuantileSample lag;                  // from stamp to record [s]
    std::map<std::int64_t, Span> spans;  // of stamps, by whole seconds of their lag
    bool rules = false;
  };

  double offset() const;

  std::map<InputName, Input> inputs_;
  Span recorded_{ros::TIME_MAX, ros::TIME_MIN};
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_CLOCK_H
