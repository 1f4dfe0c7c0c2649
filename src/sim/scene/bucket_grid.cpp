#include "sim/scene/bucket_grid.h"

namespace place_memory::sim {

namespace {

// Loose by the corner of a cell, which costs a test too many now and then and misses nothing.
bool touches(const BucketGrid::Item& item, Vec2 cell_center, double half_diagonal) {
  return distanceToSegment(cell_center, item.a, item.b) <= half_diagonal + item.radius;
}

}  // namespace

BucketGrid::BucketGrid(Vec2 lower, Vec2 upper, double cell_size, const std::vector<Item>& items)
    : lower_(lower),
      upper_(upper),
      cell_size_(cell_size),
      columns_(static_cast<int>(std::ceil((upper.x - lower.x) / cell_size)) + 1),
      rows_(static_cast<int>(std::ceil((upper.y - lower.y) / cell_size)) + 1) {
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  upper_ = lower_ + Vec2{columns_ * cell_size_, rows_ * cell_size_};
  first_.assign(cells + 1, 0);
  const double half_diagonal = 0.7072 * cell_size_;
  const auto for_cells = [&](const Item& item, auto&& use) {
    const int c1 = clampedCell(std::fmax(item.a.x, item.b.x) + item.radius, lower_.x, columns_);
    const int r1 = clampedCell(std::fmax(item.a.y, item.b.y) + item.radius, lower_.y, rows_);
    const int c0 = clampedCell(std::fmin(item.a.x, item.b.x) - item.radius, lower_.x, columns_);
    for (int r = clampedCell(std::fmin(item.a.y, item.b.y) - item.radius, lower_.y, rows_); r <= r1;
         ++r) {
      for (int c = c0; c <= c1; ++c) {
        const Vec2 center = lower_ + Vec2{(c + 0.5) * cell_size_, (r + 0.5) * cell_size_};
        if (touches(item, center, half_diagonal)) use(cellIndex(c, r));
      }
    }
  };
  for (const Item& item : items) {
    for_cells(item, [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < cells; ++cell) first_[cell + 1] += first_[cell];
  ids_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t id = 0; id < items.size(); ++id) {
    for_cells(items[id],
              [&](std::size_t cell) { ids_[next[cell]++] = static_cast<std::uint32_t>(id); });
  }
}

BucketGrid::Axis BucketGrid::startAxis(double position, double lower, double direction, int count,
                                       double entry) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const int cell = clampedCell(position, lower, count);
  if (direction == 0.0) return {cell, 0, kNever, kNever};
  const int step = direction > 0.0 ? 1 : -1;
  const double border = lower + (cell + (step > 0 ? 1 : 0)) * cell_size_;
  return {cell, step, entry + (border - position) / direction, cell_size_ / std::fabs(direction)};
}

// Clips the ray to the bounds, axis by axis.
bool BucketGrid::entersAt(Vec2 origin, Vec2 direction, double& entry) const {
  double leave = std::numeric_limits<double>::infinity();
  entry = 0.0;
  const auto clip = [&](double position, double along, double low, double high) {
    if (along == 0.0) return position >= low && position <= high;
    const double t0 = (low - position) / along;
    const double t1 = (high - position) / along;
    entry = std::fmax(entry, std::fmin(t0, t1));
    leave = std::fmin(leave, std::fmax(t0, t1));
    return entry <= leave;
  };
  return clip(origin.x, direction.x, lower_.x, upper_.x) &&
         clip(origin.y, direction.y, lower_.y, upper_.y);
}

}  // namespace place_memory::sim
