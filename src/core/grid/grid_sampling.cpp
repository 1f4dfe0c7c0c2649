#include "core/grid/grid_sampling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace place_memory::core {
namespace {

std::int8_t rounded(double evidence) {
  return static_cast<std::int8_t>(evidence + (evidence < 0.0 ? -0.5 : 0.5));
}

}  // namespace

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

GridSampling::Spot GridSampling::spotOf(double x, double y) const {
  const double dx = x - pose_.x;
  const double dy = y - pose_.y;
  return {(cosine_ * dx + sine_ * dy) / cell_size_ + 0.5 * (kPadded - 1),
          (cosine_ * dy - sine_ * dx) / cell_size_ + 0.5 * (kPadded - 1)};
}

double GridSampling::at(const Spot& spot) const {
  const auto [u, v] = spot;
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
  const double step = resolution_ / samples_;
  double sum = 0.0;
  double most = 0.0;
  for (int row = 0; row < samples_; ++row) {
    for (int column = 0; column < samples_; ++column) {
      const double evidence = at(spotOf(x + (column + 0.5) * step, y + (row + 0.5) * step));
      sum += evidence;
      most = std::max(most, evidence);
    }
  }
  return most > 0.0 ? most : sum / (samples_ * samples_);
}

// The row's cells lie on a straight line through the grid, of which only a part may be in it.
void GridSampling::sampleRow(double x, double y, std::int8_t* evidence) const {
  const Spot first = spotOf(x + 0.5 * resolution_, y + 0.5 * resolution_);
  const double du = cosine_ * resolution_ / cell_size_;
  const double dv = -sine_ * resolution_ / cell_size_;
  double begin = 0.0;
  double end = kTileSize - 1;
  for (const auto& [start, step] : {std::pair(first.u, du), std::pair(first.v, dv)}) {
    if (std::abs(step) < 1e-9) continue;  // as good as parallel to that side
    const double one = -start / step;
    const double other = (kPadded - 1 - start) / step;
    begin = std::max(begin, std::min(one, other) - 1.0);
    end = std::min(end, std::max(one, other) + 1.0);
  }
  std::fill(evidence, evidence + kTileSize, std::int8_t{0});
  for (int column = static_cast<int>(std::min<double>(begin, kTileSize)); column <= end; ++column) {
    evidence[column] = rounded(at({first.u + column * du, first.v + column * dv}));
  }
}

bool GridSampling::sample(std::int64_t tile_column, std::int64_t tile_row,
                          TileEvidence& evidence) const {
  const double x = static_cast<double>(tile_column * kTileSize) * resolution_;
  for (int row = 0; row < kTileSize; ++row) {
    const double y = static_cast<double>(tile_row * kTileSize + row) * resolution_;
    std::int8_t* cells = &evidence[static_cast<std::size_t>(row * kTileSize)];
    if (samples_ == 1) {
      sampleRow(x, y, cells);
      continue;
    }
    for (int column = 0; column < kTileSize; ++column) {
      cells[column] = rounded(inCell(x + column * resolution_, y));
    }
  }
  return std::any_of(evidence.begin(), evidence.end(), [](std::int8_t cell) { return cell != 0; });
}

}  // namespace place_memory::core
