#ifndef PLACE_MEMORY_NODE_SCAN_TURN_WORDS_H
#define PLACE_MEMORY_NODE_SCAN_TURN_WORDS_H

#include <optional>
#include <string>

#include "core/sensing/base_watch.h"

namespace place_memory::node {

/// Of what a turn was made, for people.
struct TurnSources {
  std::string command_topic;  ///< as it is resolved
  bool listened = true;       ///< something is subscribed to it
  std::string yaw;            ///< by what the robot's yaw is known, e.g. "odometry (...)"
  bool yaw_is_compass = false;
  std::optional<double> compass;  ///< by how much it turned meanwhile, beside odometry [rad]
};

/// What was sent and what came back; empty where nothing was sent.
std::string sentAndTurned(const core::BaseWatch& base, const TurnSources& sources);

/// Why the turn was ended, and what to do. The base must have a fault.
std::string faultInWords(const core::BaseWatch& base, const TurnSources& sources);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_TURN_WORDS_H
