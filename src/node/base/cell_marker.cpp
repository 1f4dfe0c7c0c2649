#include "node/base/cell_marker.h"

#include <geometry_msgs/Point.h>

#include "node/base/conversions.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

constexpr int kOccupied = 12;        // evidence of a cell that is rather occupied than not
constexpr double kShare = 0.8;       // of a cell's side that is drawn: what lies below shows
constexpr double kThickness = 0.01;  // [m]
constexpr float kAlpha = 0.85F;

}  // namespace

Marker toCellMarker(const core::EvidenceGrid& grid, const core::Pose2d& frame_from_grid,
                    const std_msgs::Header& header, const Rgb& color, double level) {
  const core::GridGeometry& geometry = grid.geometry();
  Marker marker;
  marker.header = header;
  marker.header.stamp = ros::Time();  // rviz: drawn where the frame is, not where it was then
  marker.ns = "cells";
  marker.type = Marker::CUBE_LIST;
  marker.pose = toPose(frame_from_grid);
  marker.pose.position.z = level;
  marker.scale.x = marker.scale.y = kShare * geometry.cell_size;
  marker.scale.z = kThickness;
  marker.color = toColor(color, kAlpha);
  for (int row = 0; row < core::kGridSize; ++row) {
    for (int column = 0; column < core::kGridSize; ++column) {
      if (grid.at(row, column) < kOccupied) continue;
      geometry_msgs::Point& point = marker.points.emplace_back();
      point.x = geometry.centre(column);
      point.y = geometry.centre(row);
    }
  }
  // rviz reports a list without points as an error.
  marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  return marker;
}

}  // namespace place_memory::node
