#ifndef PLACE_MEMORY_NODE_BASE_ROS_TIME_H
#define PLACE_MEMORY_NODE_BASE_ROS_TIME_H

#include <ros/time.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace place_memory::node {

// ros::Time and ros::Duration throw where a sum or a difference does not fit into their 32 bits of
// seconds, so nothing is reckoned with them: every time that comes in is turned into nanoseconds.

inline std::chrono::nanoseconds toNanoseconds(const ros::Time& time) {
  return std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec);
}

inline std::chrono::nanoseconds toNanoseconds(double seconds) {
  return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

inline double toSeconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

/// E.g. "2.5 s".
inline std::string inSeconds(std::chrono::nanoseconds time) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << toSeconds(time) << " s";
  return text.str();
}

inline std::chrono::nanoseconds rosNow() { return toNanoseconds(ros::Time::now()); }

/// By a clock that nobody sets.
inline std::chrono::nanoseconds steadyNow() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_ROS_TIME_H
