#ifndef PLACE_MEMORY_PICTURE_GRID_PICTURE_H
#define PLACE_MEMORY_PICTURE_GRID_PICTURE_H

#include <string>

#include "picture/picture.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::picture {

/// Of a cell with this evidence, which is not 0.
Color shadeOf(int evidence);

/// Pictures of grids as SVG, east to the right and north up, all of one frame: that of the scan.
/// Dark is occupied, white is empty, grey is unsensed; an arrow is the robot, by its pose in that
/// frame.

std::string scanPicture(const core::EvidenceGrid& scan, const core::Pose2d& robot);

/// A place's grid, laid where it aligns with the scan.
std::string placePicture(const core::EvidenceGrid& place, const core::Pose2d& place_from_scan,
                         const core::Pose2d& robot);

/// A place's grid in blue below the scan's in red, of both what is occupied: where they agree it is
/// violet.
std::string overlayPicture(const core::EvidenceGrid& scan, const core::EvidenceGrid& place,
                           const core::Pose2d& place_from_scan, const core::Pose2d& robot);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_GRID_PICTURE_H
