#ifndef PLACE_MEMORY_CORE_VIEWS_EXPECTED_VIEW_H
#define PLACE_MEMORY_CORE_VIEWS_EXPECTED_VIEW_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/recognize/grid_view.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

constexpr std::size_t kViewBearings = 24;

/// What sonars should hear all around a robot, by bearing: of these the first is straight ahead,
/// the others follow counter-clockwise.
using ExpectedView = std::array<GridView, kViewBearings>;

/// Of which bearings something is to count.
using Bearings = std::array<bool, kViewBearings>;

double bearingOf(std::size_t index);  ///< [rad], in [-pi, pi)

/// By a grid, from where the robot stands in the grid's frame.
ExpectedView expectedView(const EvidenceGrid& grid, const Pose2d& grid_from_robot);

/// Bearings at which the view tells something of what lies there.
Bearings knownOf(const ExpectedView& view);

/// The bearings within half a right angle of one of them.
Bearings sectorAbout(std::size_t index);

/// From a spot, which is the first, and from some decimetres beside it.
std::vector<ExpectedView> viewsAbout(const EvidenceGrid& grid, const Pose2d& grid_from_robot);

/// How likely it is that a robot hears `view` where it should hear one of `others`: 1 where no
/// bearing that both know parts it from the one that looks the most like it, never 0. Only
/// `counted` bearings count.
double likeness(const ExpectedView& view, const std::vector<ExpectedView>& others,
                const Bearings& counted);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VIEWS_EXPECTED_VIEW_H
