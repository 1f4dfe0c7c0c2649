#ifndef PLACE_MEMORY_NODE_ANSWER_ROUTE_MESSAGES_H
#define PLACE_MEMORY_NODE_ANSWER_ROUTE_MESSAGES_H

#include <nav_msgs/Path.h>
#include <place_memory/Route.h>

#include <string>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/core/routes.h"

namespace place_memory::node {

/// Where the robot stood at each of the places, facing the next one, and at the last one as it
/// came.
nav_msgs::Path toPath(const std::vector<core::Place>& places, const std::string& map_frame);

Route toMessage(const core::Route& route, const std::vector<core::Place>& places,
                const std::string& map_frame);

/// E.g. "hall to kitchen, 3 links, about 42 s (33 s where all is open), odds 0.78".
std::string inWords(const core::Route& route, const std::vector<core::Place>& places);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_ROUTE_MESSAGES_H
