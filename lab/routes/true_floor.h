#ifndef PLACE_MEMORY_ROUTES_TRUE_FLOOR_H
#define PLACE_MEMORY_ROUTES_TRUE_FLOOR_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "place_memory/core/pose2d.h"
#include "sim/scene/scene.h"

namespace place_memory::routes {

/// What of a world's floor a robot can get to, and what of that can be seen from where.
class TrueFloor {
 public:
  /// `radius`: of the robot [m]; `reach`: of its sensors [m].
  TrueFloor(const sim::Scene& scene, const core::Pose2d& start, double radius, double reach);

  /// Share of the cells that the robot can get to which lie within its sensors' reach, with nothing
  /// between, of some spot of the way until there; by spot.
  std::vector<double> seenShares(const std::vector<core::Pose2d>& way) const;

  struct Tour {
    double length = 0.0;         ///< [m]
    std::size_t viewpoints = 0;  ///< beside the start
  };
  /// Way of a robot that knows the floor, from the start to spots that show so large a share of it,
  /// and back. The spots are chosen greedily, each the one that shows most that was not shown
  /// yet; the tour is that of nearest neighbours, bettered by 2-opt; ways between them are the
  /// shortest ones.
  Tour tour(double share) const;

  double area() const;  ///< that the robot can get to [m^2]

 private:
  using Cell = std::size_t;
  using Seen = std::vector<std::uint8_t>;  ///< by cell

  Cell cellAt(double x, double y) const;
  core::Pose2d centre(Cell cell) const;
  void fill(const core::Pose2d& start);
  void look(const core::Pose2d& from, std::vector<Cell>& found) const;
  std::vector<Cell> viewpoints(double share) const;
  std::vector<float> lengthsFrom(Cell from) const;

  double reach_;
  double left_, bottom_;
  std::size_t columns_, rows_;
  std::vector<std::uint8_t> opaque_;
  std::vector<std::uint8_t> room_;  ///< for the robot's middle
  std::vector<std::uint8_t> is_reached_;
  std::vector<Cell> reached_;
  Cell start_ = 0;
};

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_ROUTES_TRUE_FLOOR_H
