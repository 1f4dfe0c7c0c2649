#include "core/explore/free_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace place_memory::core {
namespace {

template <class Visit>
void forEachCellIn(const FreeSpace& space, const MapDisc& disc, const Visit& visit) {
  const double step = space.resolution();
  for (double y = disc.y - disc.radius; y <= disc.y + disc.radius; y += step) {
    for (double x = disc.x - disc.radius; x <= disc.x + disc.radius; x += step) {
      if (std::hypot(x - disc.x, y - disc.y) > disc.radius) continue;
      if (const auto cell = space.cellAt(x, y)) visit(*cell);
    }
  }
}

}  // namespace

FreeSpace::FreeSpace(const FreeSpaceOptions& options, const SurveyedCells& survey,
                     const Pose2d& robot, const std::vector<MapDisc>& barriers)
    : columns_(survey.cells.columns),
      rows_(survey.cells.rows),
      resolution_(survey.cells.resolution),
      left_(survey.cells.left),
      bottom_(survey.cells.bottom),
      states_(survey.cells.evidence.size(), State::kUnknown),
      barred_(survey.cells.evidence.size(), 0),
      passable_(survey.cells.evidence.size(), 0) {
  const std::vector<std::int8_t>& evidence = survey.cells.evidence;
  for (Cell cell = 0; cell < states_.size(); ++cell) {
    if (evidence[cell] >= options.occupied) states_[cell] = State::kOccupied;
    if (evidence[cell] <= options.empty) states_[cell] = State::kEmpty;
  }
  std::vector<MapDisc> driven{{robot.x, robot.y, options.stands}};
  for (const Pose2d& spot : survey.trail) driven.push_back({spot.x, spot.y, options.trail});
  for (const MapDisc& disc : driven) {
    forEachCellIn(*this, disc, [&](Cell cell) { states_[cell] = State::kEmpty; });
  }
  for (const MapDisc& barrier : barriers) {
    forEachCellIn(*this, barrier, [&](Cell cell) { barred_[cell] = 1; });
  }
  measure();
  for (Cell cell = 0; cell < states_.size(); ++cell) {
    passable_[cell] = states_[cell] == State::kEmpty && clearances_[cell] > options.radius ? 1 : 0;
  }
  for (const MapDisc& disc : driven) {
    const bool is_robot = &disc == &driven.front();
    forEachCellIn(*this, disc, [&](Cell cell) {
      if (is_robot || barred_[cell] == 0) passable_[cell] = 1;
    });
  }
}

// Distances along rows, columns and diagonals (Borgefors 1986, chamfer distance): 8 % off at most.
void FreeSpace::measure() {
  const double straight = resolution_, across = resolution_ * std::sqrt(2.0);
  clearances_.assign(states_.size(), kFar);
  for (Cell cell = 0; cell < states_.size(); ++cell) {
    if (states_[cell] == State::kOccupied || barred_[cell] != 0) clearances_[cell] = 0.0;
  }
  const auto width = static_cast<Cell>(columns_);
  const auto pull = [&](Cell cell, Cell from, double step) {
    clearances_[cell] = std::min(clearances_[cell], clearances_[from] + step);
  };
  const auto sweep = [&](int row, int column, int back) {
    const Cell cell = static_cast<Cell>(row) * width + static_cast<Cell>(column);
    const bool has_side = back < 0 ? column > 0 : column + 1 < columns_;
    const bool has_row = back < 0 ? row > 0 : row + 1 < rows_;
    const Cell beside = back < 0 ? cell - 1 : cell + 1;
    if (has_side) pull(cell, beside, straight);
    if (!has_row) return;
    const Cell below = back < 0 ? cell - width : cell + width;
    pull(cell, below, straight);
    if (column > 0) pull(cell, below - 1, across);
    if (column + 1 < columns_) pull(cell, below + 1, across);
  };
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) sweep(row, column, -1);
  }
  for (int row = rows_ - 1; row >= 0; --row) {
    for (int column = columns_ - 1; column >= 0; --column) sweep(row, column, 1);
  }
}

std::optional<FreeSpace::Cell> FreeSpace::cellAt(double x, double y) const {
  const double column = std::floor((x - left_) / resolution_);
  const double row = std::floor((y - bottom_) / resolution_);
  if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return std::nullopt;
  return static_cast<Cell>(row) * static_cast<Cell>(columns_) + static_cast<Cell>(column);
}

Pose2d FreeSpace::centre(Cell cell) const {
  const auto width = static_cast<Cell>(columns_);
  return {left_ + (static_cast<double>(cell % width) + 0.5) * resolution_,
          bottom_ + (static_cast<double>(cell / width) + 0.5) * resolution_, 0.0};
}

double FreeSpace::distance(Cell one, Cell other) const {
  const Pose2d a = centre(one), b = centre(other);
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace place_memory::core
