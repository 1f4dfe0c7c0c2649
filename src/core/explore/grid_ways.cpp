#include "core/explore/grid_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace place_memory::core {
namespace {

constexpr double kNearCost = 3.0;  // a metre counts so much more right beside something
constexpr float kUnseen = std::numeric_limits<float>::infinity();

}  // namespace

GridWays::GridWays(const FreeSpace& space, const Pose2d& from, double wide_berth)
    : space_(space),
      costs_(space.size(), kUnseen),
      lengths_(space.size(), -1.0F),
      before_(space.size(), 0) {
  const std::optional<Cell> start = space.cellAt(from.x, from.y);
  if (!start) return;
  using Open = std::pair<float, Cell>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  costs_[*start] = 0.0F;
  lengths_[*start] = 0.0F;
  before_[*start] = *start;
  open.emplace(0.0F, *start);
  const double straight = space.resolution(), across = straight * std::sqrt(2.0);
  while (!open.empty()) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost > costs_[cell]) continue;
    const Cell at = cell;
    const float so_far = cost;
    space.forEachNeighbour(at, [&](Cell next, bool is_across) {
      if (!space.isPassable(next)) return;
      const double step = is_across ? across : straight;
      const double near = std::max(0.0, 1.0 - space.clearance(next) / wide_berth);
      const float sum = so_far + static_cast<float>(step * (1.0 + kNearCost * near));
      if (sum >= costs_[next]) return;
      costs_[next] = sum;
      lengths_[next] = lengths_[at] + static_cast<float>(step);
      before_[next] = at;
      open.emplace(sum, next);
    });
  }
}

std::optional<GridWays::Cell> GridWays::reachedNear(double x, double y, double radius) const {
  std::optional<Cell> best;
  double nearest = std::numeric_limits<double>::infinity();
  const double step = space_.resolution();
  for (double cy = y - radius; cy <= y + radius; cy += step) {
    for (double cx = x - radius; cx <= x + radius; cx += step) {
      const std::optional<Cell> cell = space_.cellAt(cx, cy);
      if (!cell || !reaches(*cell)) continue;
      const Pose2d centre = space_.centre(*cell);
      const double distance = std::hypot(centre.x - x, centre.y - y);
      if (distance > radius || distance >= nearest) continue;
      nearest = distance;
      best = cell;
    }
  }
  return best;
}

bool GridWays::isStraight(Cell from, Cell to, double room) const {
  const Pose2d a = space_.centre(from), b = space_.centre(to);
  const int steps =
      std::max(1, static_cast<int>(2.0 * space_.distance(from, to) / space_.resolution()));
  for (int i = 1; i < steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const auto cell = space_.cellAt(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
    if (!cell || !space_.isPassable(*cell) || space_.clearance(*cell) < room) return false;
  }
  return true;
}

std::vector<Pose2d> GridWays::wayTo(Cell cell) const {
  if (!reaches(cell)) return {};
  std::vector<Cell> cells{cell};
  while (before_[cells.back()] != cells.back()) cells.push_back(before_[cells.back()]);
  std::reverse(cells.begin(), cells.end());
  std::vector<Pose2d> way;
  std::size_t at = 0;
  while (at + 1 < cells.size()) {
    // A straight line may come no nearer to things than the way itself does.
    std::size_t next = at + 1;
    double room = space_.clearance(cells[next]);
    for (std::size_t i = at + 2; i < cells.size(); ++i) {
      room = std::min(room, space_.clearance(cells[i]));
      if (isStraight(cells[at], cells[i], room)) next = i;
    }
    at = next;
    way.push_back(space_.centre(cells[at]));
  }
  if (way.empty()) way.push_back(space_.centre(cell));
  return way;
}

}  // namespace place_memory::core
