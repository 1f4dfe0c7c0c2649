#ifndef PLACE_MEMORY_CORE_EXPLORE_FREE_SPACE_H
#define PLACE_MEMORY_CORE_EXPLORE_FREE_SPACE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/explore/surveyed_map.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A disc of the map.
struct MapDisc {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;  ///< [m]
};

struct FreeSpaceOptions {
  int occupied = 10;  ///< evidence from which a cell is occupied
  int empty = -6;     ///< up to which it is empty; between the two it is unknown
  /// Nothing may be nearer to the robot's middle [m]; on the map things are thicker than they are.
  double radius = 0.15;
  double wide_berth = 0.6;  ///< it keeps so far from things where there is room [m]
  /// What the robot stands on is free, whatever the map says, so far around its middle [m].
  double stands = 0.35;
  double trail = 0.15;  ///< likewise, to each side of where it drove [m]
};

/// Where on the building's map a robot has room.
class FreeSpace {
 public:
  using Cell = std::size_t;
  enum class State : std::uint8_t { kUnknown, kEmpty, kOccupied };

  /// Where the robot was, along `trail`, it can go again, however narrow it looks; `barriers` are
  /// not to be driven through, whatever the map says.
  FreeSpace(const FreeSpaceOptions& options, const SurveyedCells& survey, const Pose2d& robot,
            const std::vector<MapDisc>& barriers);

  std::size_t size() const { return states_.size(); }
  int columns() const { return columns_; }
  double resolution() const { return resolution_; }
  State state(Cell cell) const { return states_[cell]; }
  /// To the nearest cell that is occupied or barred, as far as kFar [m].
  double clearance(Cell cell) const { return clearances_[cell]; }
  /// Empty, with room for the robot.
  bool isPassable(Cell cell) const { return passable_[cell] != 0; }

  /// Nothing beyond the map.
  std::optional<Cell> cellAt(double x, double y) const;
  Pose2d centre(Cell cell) const;
  double distance(Cell one, Cell other) const;

  /// Up to eight cells around a cell, and whether each is across a corner.
  template <class Visit>
  void forEachNeighbour(Cell cell, const Visit& visit) const {
    const int column = static_cast<int>(cell % static_cast<std::size_t>(columns_));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(columns_));
    for (int down = -1; down <= 1; ++down) {
      for (int along = -1; along <= 1; ++along) {
        const int c = column + along, r = row + down;
        if ((down == 0 && along == 0) || c < 0 || r < 0 || c >= columns_ || r >= rows_) continue;
        visit(static_cast<Cell>(r) * static_cast<Cell>(columns_) + static_cast<Cell>(c),
              down != 0 && along != 0);
      }
    }
  }

  static constexpr double kFar = 1.0;  ///< [m]

 private:
  void measure();

  int columns_ = 0;
  int rows_ = 0;
  double resolution_;
  double left_;
  double bottom_;
  std::vector<State> states_;
  std::vector<std::uint8_t> barred_;
  std::vector<double> clearances_;
  std::vector<std::uint8_t> passable_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_FREE_SPACE_H
