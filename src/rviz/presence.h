#ifndef PLACE_MEMORY_RVIZ_PRESENCE_H
#define PLACE_MEMORY_RVIZ_PRESENCE_H

#include <set>
#include <string>
#include <vector>

namespace place_memory::panel {

/// Whether a node is there, and what it offers.
struct Presence {
  enum class Kind {
    kUnknown,  ///< nobody has looked yet
    kNoMaster,
    kAway,
    kThere,
  };

  Kind kind = Kind::kUnknown;
  std::set<std::string> services;  ///< below the node's name, e.g. learn_place
  std::set<std::string> actions;   ///< likewise, e.g. scan
  std::string incarnation;         ///< another one after each restart of the node
  std::vector<std::string> nodes;  ///< every node of this kind that the master knows
};

/// Asks the master, and tries whether the node answers there. Takes as long as the network does.
Presence lookFor(const std::string& node);

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PRESENCE_H
