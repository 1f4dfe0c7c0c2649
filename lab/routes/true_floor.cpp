#include "routes/true_floor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace place_memory::routes {
namespace {

constexpr double kCell = 0.1;  // [m]
// A cell with something so near its middle stops sight [m]: half a diagonal, or walls, which have
// no thickness, would fall between two cells.
constexpr double kOpaque = 0.0708;
constexpr int kRays = 720;
constexpr double kLookEvery = 0.25;  // of the way [m]
constexpr std::size_t kLattice = 5;  // of candidates for viewpoints [cells]

/// Closed, over the spots of a table of lengths; begins at spot 0.
std::vector<std::size_t> nearestNeighbours(const std::vector<std::vector<float>>& lengths) {
  std::vector<std::size_t> tour{0};
  std::vector<std::uint8_t> is_done(lengths.size(), 0);
  is_done[0] = 1;
  while (tour.size() < lengths.size()) {
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (is_done[i] != 0 || lengths[tour.back()][i] >= least) continue;
      least = lengths[tour.back()][i];
      best = i;
    }
    if (best == 0) break;
    is_done[best] = 1;
    tour.push_back(best);
  }
  return tour;
}

void untangle(const std::vector<std::vector<float>>& lengths, std::vector<std::size_t>& tour) {
  const auto length = [&](std::size_t i, std::size_t j) {
    return lengths[tour[i % tour.size()]][tour[j % tour.size()]];
  };
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t i = 0; i + 2 < tour.size(); ++i) {
      for (std::size_t j = i + 2; j < tour.size(); ++j) {
        const float now = length(i, i + 1) + length(j, j + 1);
        const float then = length(i, j) + length(i + 1, j + 1);
        if (then >= now - 1e-4F) continue;
        std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        is_better = true;
      }
    }
  }
}

}  // namespace

TrueFloor::TrueFloor(const sim::Scene& scene, const core::Pose2d& start, double radius,
                     double reach)
    : reach_(reach),
      left_(scene.lowerBound().x - 1.0),
      bottom_(scene.lowerBound().y - 1.0),
      columns_(static_cast<std::size_t>((scene.upperBound().x - left_ + 1.0) / kCell)),
      rows_(static_cast<std::size_t>((scene.upperBound().y - bottom_ + 1.0) / kCell)),
      opaque_(columns_ * rows_, 0),
      room_(columns_ * rows_, 0),
      is_reached_(columns_ * rows_, 0) {
  for (Cell cell = 0; cell < opaque_.size(); ++cell) {
    const core::Pose2d at = centre(cell);
    opaque_[cell] = scene.isFree({at.x, at.y}, kOpaque) ? 0 : 1;
    room_[cell] = scene.isFree({at.x, at.y}, radius) ? 1 : 0;
  }
  fill(start);
}

TrueFloor::Cell TrueFloor::cellAt(double x, double y) const {
  const auto column =
      static_cast<Cell>(std::clamp((x - left_) / kCell, 0.0, static_cast<double>(columns_ - 1)));
  const auto row =
      static_cast<Cell>(std::clamp((y - bottom_) / kCell, 0.0, static_cast<double>(rows_ - 1)));
  return row * columns_ + column;
}

core::Pose2d TrueFloor::centre(Cell cell) const {
  return {left_ + (static_cast<double>(cell % columns_) + 0.5) * kCell,
          bottom_ + (static_cast<double>(cell / columns_) + 0.5) * kCell, 0.0};
}

void TrueFloor::fill(const core::Pose2d& start) {
  start_ = cellAt(start.x, start.y);
  reached_ = {start_};
  is_reached_[start_] = 1;
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    const Cell at = reached_[i];
    for (const Cell next : {at - 1, at + 1, at - columns_, at + columns_}) {
      if (next >= room_.size() || room_[next] == 0 || is_reached_[next] != 0) continue;
      is_reached_[next] = 1;
      reached_.push_back(next);
    }
  }
}

void TrueFloor::look(const core::Pose2d& from, std::vector<Cell>& found) const {
  found.clear();
  for (int i = 0; i < kRays; ++i) {
    const double bearing = 2.0 * core::kPi * i / kRays;
    const double c = std::cos(bearing), s = std::sin(bearing);
    for (double way = 0.0; way <= reach_; way += kCell) {
      const Cell cell = cellAt(from.x + way * c, from.y + way * s);
      if (opaque_[cell] != 0) break;
      if (is_reached_[cell] != 0) found.push_back(cell);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

double TrueFloor::area() const { return static_cast<double>(reached_.size()) * kCell * kCell; }

std::vector<double> TrueFloor::seenShares(const std::vector<core::Pose2d>& way) const {
  std::vector<double> shares;
  Seen seen(room_.size(), 0);
  std::size_t count = 0;
  std::vector<Cell> found;
  const core::Pose2d* last = nullptr;
  for (const core::Pose2d& spot : way) {
    if (!last || std::hypot(spot.x - last->x, spot.y - last->y) >= kLookEvery) {
      last = &spot;
      look(spot, found);
      for (const Cell cell : found) {
        count += seen[cell] == 0 ? 1 : 0;
        seen[cell] = 1;
      }
    }
    shares.push_back(static_cast<double>(count) / static_cast<double>(reached_.size()));
  }
  return shares;
}

std::vector<TrueFloor::Cell> TrueFloor::viewpoints(double share) const {
  std::vector<Cell> candidates;
  std::vector<std::vector<Cell>> shows;
  for (const Cell cell : reached_) {
    if (cell % columns_ % kLattice != 0 || cell / columns_ % kLattice != 0) continue;
    candidates.push_back(cell);
    look(centre(cell), shows.emplace_back());
  }
  Seen seen(room_.size(), 0);
  double left = share * static_cast<double>(reached_.size());
  std::vector<Cell> chosen;
  while (left > 0.0) {
    std::size_t best = 0, most = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const auto gain = static_cast<std::size_t>(std::count_if(
          shows[i].begin(), shows[i].end(), [&](Cell cell) { return seen[cell] == 0; }));
      if (gain <= most) continue;
      most = gain;
      best = i;
    }
    if (most == 0) break;
    for (const Cell cell : shows[best]) seen[cell] = 1;
    left -= static_cast<double>(most);
    chosen.push_back(candidates[best]);
  }
  return chosen;
}

std::vector<float> TrueFloor::lengthsFrom(Cell from) const {
  std::vector<float> lengths(room_.size(), std::numeric_limits<float>::infinity());
  using Open = std::pair<float, Cell>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  lengths[from] = 0.0F;
  open.emplace(0.0F, from);
  const auto straight = static_cast<float>(kCell);
  const float across = straight * std::sqrt(2.0F);
  while (!open.empty()) {
    const auto [length, at] = open.top();
    open.pop();
    if (length > lengths[at]) continue;
    const std::pair<Cell, float> steps[] = {
        {at - 1, straight},          {at + 1, straight},          {at - columns_, straight},
        {at + columns_, straight},   {at - columns_ - 1, across}, {at - columns_ + 1, across},
        {at + columns_ - 1, across}, {at + columns_ + 1, across}};
    for (const auto& [next, step] : steps) {
      if (next >= room_.size() || is_reached_[next] == 0 || length + step >= lengths[next])
        continue;
      lengths[next] = length + step;
      open.emplace(lengths[next], next);
    }
  }
  return lengths;
}

TrueFloor::Tour TrueFloor::tour(double share) const {
  std::vector<Cell> spots{start_};
  for (const Cell cell : viewpoints(share)) spots.push_back(cell);
  std::vector<std::vector<float>> lengths;
  for (const Cell from : spots) {
    const std::vector<float> all = lengthsFrom(from);
    std::vector<float>& row = lengths.emplace_back();
    for (const Cell to : spots) row.push_back(all[to]);
  }
  std::vector<std::size_t> tour = nearestNeighbours(lengths);
  untangle(lengths, tour);
  double sum = 0.0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    sum += static_cast<double>(lengths[tour[i]][tour[(i + 1) % tour.size()]]);
  }
  return {sum, spots.size() - 1};
}

}  // namespace place_memory::routes
