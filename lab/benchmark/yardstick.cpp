#include "yardstick.h"

#include <algorithm>
#include <cmath>

namespace place_memory::measure {
namespace {

using core::kGridSize;
using core::kPi;
using core::Pose2d;

constexpr double kWindow = 1.2;               // [m]
constexpr double kHeadingWindow = kPi / 4.0;  // [rad]
/// Steps of the first climb; each later one has half of them, down to half a cell.
constexpr double kFirstStep = 0.5 * kWindow;             // [m]
constexpr double kFirstRotation = 0.5 * kHeadingWindow;  // [rad]
constexpr int kRestarts = 8;

std::size_t cellOf(int row, int column) {
  const int cell = row * kGridSize + column;
  return static_cast<std::size_t>(cell);
}

class Climb {
 public:
  Climb(const CellClasses& scan, const CellClasses& place, double cell_size, bool any_heading)
      : scan_(scan), place_(place), cell_size_(cell_size), any_heading_(any_heading) {}

  YardstickMatch from(double yaw) {
    YardstickMatch best = evaluate({0.0, 0.0, yaw});
    double step = kFirstStep;
    double rotation = kFirstRotation;
    while (step >= 0.5 * cell_size_) {
      if (improve(step, rotation, best)) continue;
      step *= 0.5;
      rotation *= 0.5;
    }
    best.evaluations = evaluations_;
    return best;
  }

 private:
  /// One point for each cell of the scan that lies on a cell of its class (paper 4).
  YardstickMatch evaluate(const Pose2d& pose) {
    ++evaluations_;
    const auto c = static_cast<float>(std::cos(pose.yaw));
    const auto s = static_cast<float>(std::sin(pose.yaw));
    constexpr float kMiddle = 0.5F * (kGridSize - 1);
    const auto column_shift = static_cast<float>(pose.x / cell_size_) + kMiddle + 0.5F;
    const auto row_shift = static_cast<float>(pose.y / cell_size_) + kMiddle + 0.5F;
    int score = 0;
    for (int row = 0; row < kGridSize; ++row) {
      for (int column = 0; column < kGridSize; ++column) {
        const float x = static_cast<float>(column) - kMiddle;
        const float y = static_cast<float>(row) - kMiddle;
        // Cells before the first one come out below zero once a whole grid is added.
        const int to_column =
            static_cast<int>(c * x - s * y + column_shift + kGridSize) - kGridSize;
        const int to_row = static_cast<int>(s * x + c * y + row_shift + kGridSize) - kGridSize;
        if (to_column < 0 || to_column >= kGridSize || to_row < 0 || to_row >= kGridSize) continue;
        score += scan_[cellOf(row, column)] == place_[cellOf(to_row, to_column)] ? 1 : 0;
      }
    }
    return {pose, score, 0};
  }

  bool improve(double step, double rotation, YardstickMatch& best) {
    const YardstickMatch from = best;
    for (const double sign : {-1.0, 1.0}) {
      const Pose2d& at = from.place_from_scan;
      const Pose2d next[] = {{at.x + sign * step, at.y, at.yaw},
                             {at.x, at.y + sign * step, at.yaw},
                             {at.x, at.y, core::wrapAngle(at.yaw + sign * rotation)}};
      for (const Pose2d& pose : next) {
        if (std::max(std::abs(pose.x), std::abs(pose.y)) > kWindow + 1e-6) continue;
        if (!any_heading_ && std::abs(pose.yaw) > kHeadingWindow + 1e-6) continue;
        const YardstickMatch found = evaluate(pose);
        if (found.score > best.score) best = found;
      }
    }
    return best.score > from.score;
  }

  const CellClasses& scan_;
  const CellClasses& place_;
  double cell_size_;
  bool any_heading_;
  int evaluations_ = 0;
};

}  // namespace

CellClasses classesOf(const core::EvidenceGrid& grid) {
  CellClasses classes;
  std::transform(grid.cells().begin(), grid.cells().end(), classes.begin(),
                 [](std::int8_t evidence) {
                   return static_cast<std::int8_t>(evidence > 0 ? 1 : (evidence < 0 ? -1 : 0));
                 });
  return classes;
}

YardstickMatch climbByCells(const CellClasses& scan, const CellClasses& place, double cell_size,
                            bool any_heading) {
  Climb climb(scan, place, cell_size, any_heading);
  if (!any_heading) return climb.from(0.0);
  YardstickMatch best;
  for (int restart = 0; restart < kRestarts; ++restart) {
    const YardstickMatch found = climb.from(core::wrapAngle(restart * 2.0 * kPi / kRestarts));
    if (restart == 0 || found.score > best.score) best = found;
    best.evaluations = found.evaluations;
  }
  return best;
}

}  // namespace place_memory::measure
