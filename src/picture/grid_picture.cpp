#include "picture/grid_picture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "picture/svg_text.h"

namespace place_memory::picture {
namespace {

// Lengths in a picture are cells.

/// Cells whose evidence lies in [least, most] are filled alike.
struct Shade {
  int least;
  int most;
  Color fill;
};

constexpr int kOccupied = 12;  // evidence of a cell that is rather occupied than not

// Unsensed cells stay as the background is.
const std::vector<Shade>& shades() {
  static const std::vector<Shade> shades{
      {-core::EvidenceGrid::kLimit, -33, {255, 255, 255}},
      {-32, -13, {239, 239, 239}},
      {-12, -1, {220, 220, 220}},
      {1, kOccupied - 1, {160, 160, 160}},
      {kOccupied, 32, {96, 96, 96}},
      {33, core::EvidenceGrid::kLimit, {0, 0, 0}},
  };
  return shades;
}

/// Of each row the runs of cells that have the shade, as one path.
std::string path(const core::EvidenceGrid& grid, const Shade& shade) {
  const auto has = [&](int row, int column) {
    const int evidence = grid.at(row, column);
    return evidence >= shade.least && evidence <= shade.most;
  };
  std::string runs;
  for (int row = 0; row < core::kGridSize; ++row) {
    for (int column = 0; column < core::kGridSize; ++column) {
      if (!has(row, column)) continue;
      const int begin = column;
      while (column < core::kGridSize && has(row, column)) ++column;
      const std::string width = std::to_string(column - begin);
      runs += "M" + std::to_string(begin - core::kGridSize / 2) + " " +
              std::to_string(row - core::kGridSize / 2) + "h" + width + "v1h-" + width + "z";
    }
  }
  if (runs.empty()) return runs;
  return "<path fill=\"" + hex(shade.fill) + "\" d=\"" + runs + "\"/>";
}

std::string cells(const core::EvidenceGrid& grid) {
  std::string paths;
  for (const Shade& shade : shades()) paths += path(grid, shade);
  return paths;
}

std::string occupied(const core::EvidenceGrid& grid, const Color& fill) {
  return path(grid, {kOccupied, core::EvidenceGrid::kLimit, fill});
}

/// Puts what is in the frame of `pose` into the frame that the pose is in.
std::string moved(const std::string& content, const core::Pose2d& pose, double cell_size) {
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return "<g transform=\"matrix(" + decimal(c, 5) + " " + decimal(s, 5) + " " + decimal(-s, 5) +
         " " + decimal(c, 5) + " " + decimal(pose.x / cell_size, 3) + " " +
         decimal(pose.y / cell_size, 3) + ")\">" + content + "</g>";
}

std::string robotArrow(const core::Pose2d& robot, double cell_size) {
  return moved("<path fill=\"#e07000\" d=\"M2.2 0L-1.4 1.3L-.6 0L-1.4 -1.3z\"/>", robot, cell_size);
}

std::string picture(const std::string& content) {
  return "<svg viewBox=\"-32 -32 64 64\" class=\"grid\"><g transform=\"scale(1 -1)\">"
         "<path fill=\"#c4c4c4\" d=\"M-32 -32h64v64h-64z\"/>" +
         content + "</g></svg>\n";
}

}  // namespace

Color shadeOf(int evidence) {
  const auto has = [evidence](const Shade& shade) {
    return evidence >= shade.least && evidence <= shade.most;
  };
  return std::find_if(shades().begin(), shades().end(), has)->fill;
}

std::string scanPicture(const core::EvidenceGrid& scan, const core::Pose2d& robot) {
  return picture(cells(scan) + robotArrow(robot, scan.geometry().cell_size));
}

std::string placePicture(const core::EvidenceGrid& place, const core::Pose2d& place_from_scan,
                         const core::Pose2d& robot) {
  const double cell_size = place.geometry().cell_size;
  return picture(moved(cells(place), place_from_scan.inverse(), cell_size) +
                 robotArrow(robot, cell_size));
}

std::string overlayPicture(const core::EvidenceGrid& scan, const core::EvidenceGrid& place,
                           const core::Pose2d& place_from_scan, const core::Pose2d& robot) {
  const double cell_size = place.geometry().cell_size;
  return picture("<path fill=\"#ffffff\" d=\"M-32 -32h64v64h-64z\"/>" +
                 moved(occupied(place, {0x30, 0x70, 0xff}), place_from_scan.inverse(), cell_size) +
                 "<g fill-opacity=\".6\">" + occupied(scan, {0xff, 0x20, 0x20}) + "</g>" +
                 robotArrow(robot, cell_size));
}

}  // namespace place_memory::picture
