#ifndef PLACE_MEMORY_NODE_BASE_CELL_MARKER_H
#define PLACE_MEMORY_NODE_BASE_CELL_MARKER_H

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "node/base/colors.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// What is occupied in a grid, in one colour, for rviz: its Map display mixes the greys of grids
/// that lie on each other. The grid's own frame has the pose `frame_from_grid` in that of the
/// header. `level`: height [m], so that one grid lies above another. Where nothing is occupied the
/// marker before it goes.
visualization_msgs::Marker toCellMarker(const core::EvidenceGrid& grid,
                                        const core::Pose2d& frame_from_grid,
                                        const std_msgs::Header& header, const Rgb& color,
                                        double level);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_CELL_MARKER_H
