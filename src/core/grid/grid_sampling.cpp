#include "core/grid/grid_sampling.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {

GridSampling::GridSampling(const EvidenceGrid& grid, const Pose2d& pose, double resolution)
    : pose_(pose),
      cosine_(std::cos(pose.yaw)),
      sine_(std::sin(pose.yaw)),
      cell_size_(grid.geometry().cell_size),
      resolution_(resolution),
      samples_(std::max(1, static_cast<int>(std::ceil(resolution / cell_size_ - 1e-9)))) {
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      cells_[static_cast<std::size_t>((row + 1) * kPadded + column + 1)] = grid.at(row, column);
    }
  }
}

GridSampling::TileSpan GridSampling::span() const {
  const double reach = (0.5 * kGridSize + 0.5) * cell_size_ * (std::abs(cosine_) + std::abs(sine_));
  const double tile = kTileSize * resolution_;
  const auto tile_of = [tile](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / tile));
  };
  return {tile_of(pose_.x - reach), tile_of(pose_.x + reach), tile_of(pose_.y - reach),
          tile_of(pose_.y + reach)};
}

double GridSampling::at(double x, double y) const {
  const double dx = x - pose_.x;
  const double dy = y - pose_.y;
  // In cells, from the centre of the padding's first one.
  const double u = (cosine_ * dx + sine_ * dy) / cell_size_ + 0.5 * (kPadded - 1);
  const double v = (cosine_ * dy - sine_ * dx) / cell_size_ + 0.5 * (kPadded - 1);
  if (!(u > 0.0 && v > 0.0 && u < kPadded - 1 && v < kPadded - 1)) return 0.0;
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  const double right = u - column;
  const double up = v - row;
  const std::int8_t* below = &cells_[static_cast<std::size_t>(row * kPadded + column)];
  const std::int8_t* above = below + kPadded;
  return (1.0 - up) * ((1.0 - right) * below[0] + right * below[1]) +
         up * ((1.0 - right) * above[0] + right * above[1]);
}

double GridSampling::inCell(double x, double y) const {
  if (samples_ == 1) return at(x + 0.5 * resolution_, y + 0.5 * resolution_);
  const double step = resolution_ / samples_;
  double sum = 0.0;
  double most = 0.0;
  for (int row = 0; row < samples_; ++row) {
    for (int column = 0; column < samples_; ++column) {
      const double evidence = at(x + (column + 0.5) * step, y + (row + 0.5) * step);
      sum += evidence;
      most = std::max(most, evidence);
    }
  }
  return most > 0.0 ? most : sum / (samples_ * samples_);
}

bool GridSampling::sample(std::int64_t tile_column, std::int64_t tile_row,
                          TileEvidence& evidence) const {
  bool says_something = false;
  std::size_t cell = 0;
  for (int row = 0; row < kTileSize; ++row) {
    const double y = static_cast<double>(tile_row * kTileSize + row) * resolution_;
    for (int column = 0; column < kTileSize; ++column) {
      const double x = static_cast<double>(tile_column * kTileSize + column) * resolution_;
      const auto value = static_cast<std::int8_t>(std::lround(inCell(x, y)));
      evidence[cell++] = value;
      says_something = says_something || value != 0;
    }
  }
  return says_something;
}

}  // namespace place_memory::core
