#ifndef PLACE_MEMORY_NODE_MAP_FUSED_MAP_MESSAGE_H
#define PLACE_MEMORY_NODE_MAP_FUSED_MAP_MESSAGE_H

#include <nav_msgs/OccupancyGrid.h>
#include <std_msgs/Header.h>

#include "config/parameters.h"
#include "core/mapping/fused_map.h"

namespace place_memory::node {

/// The map as map_server would publish it: each cell is 100 (occupied), 0 (empty) or -1 (unknown),
/// by its probability, given the prior `sonar_prior`. Without a cell, it is a single unknown one at
/// the origin: move_base and rviz take no map without cells.
nav_msgs::OccupancyGrid toMessage(const core::FusedCells& cells, const config::MapOptions& options,
                                  double sonar_prior, const std_msgs::Header& header);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_FUSED_MAP_MESSAGE_H
