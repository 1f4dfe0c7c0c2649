#include "fixed_metric.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr auto kEmpty = static_cast<std::size_t>(CellClass::kEmpty);
constexpr auto kUnsensed = static_cast<std::size_t>(CellClass::kUnsensed);
constexpr auto kOccupied = static_cast<std::size_t>(CellClass::kOccupied);

/// Points below this share of the largest weight are left to rounding, so that sums fit.
constexpr double kLeastShare = 1e-6;
/// Sums of three stay below 2^63.
constexpr double kMost = 1LL << 60;

/// What a pair earns beside what its cells would earn on unsensed ones.
double together(const PairWeights& weights, std::size_t recognition, std::size_t learned) {
  return weights[recognition][learned] - weights[recognition][kUnsensed] -
         weights[kUnsensed][learned] + weights[kUnsensed][kUnsensed];
}

}  // namespace

FixedMetric::FixedMetric(const LatticeMetric& metric)
    : metric_(metric),
      points_{together(metric.weights, kOccupied, kOccupied),
              together(metric.weights, kOccupied, kEmpty),
              together(metric.weights, kEmpty, kOccupied),
              together(metric.weights, kEmpty, kEmpty)} {
  double most = std::max({std::abs(points_.occupied_occupied), std::abs(points_.occupied_empty),
                          std::abs(points_.empty_occupied), std::abs(points_.empty_empty)});
  for (const auto& row : metric.weights) {
    for (const double weight : row) most = std::max(most, kLeastShare * std::abs(weight));
  }
  if (most > 0.0) scale_ = std::exp2(30.0) / (kMostShare * most);
}

PairFactors FixedMetric::factors(const PairShares& shares) const {
  const auto factor = [this](double points, double share) {
    return static_cast<std::int32_t>(fixed(points * share));
  };
  return {factor(points_.occupied_occupied, shares.occupied_occupied),
          factor(points_.occupied_empty, shares.occupied_empty),
          factor(points_.empty_occupied, shares.empty_occupied),
          factor(points_.empty_empty, shares.empty_empty)};
}

std::int64_t FixedMetric::ofTransform(const CellTotals& inside, CellShift shift, int turn) const {
  const PairWeights& weights = metric_.weights;
  const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
  return fixed(inside.occupied * (weights[kOccupied][kUnsensed] - weights[kUnsensed][kUnsensed]) +
               inside.empty * (weights[kEmpty][kUnsensed] - weights[kUnsensed][kUnsensed]) -
               metric_.shift_cost * cells - metric_.turn_cost * turn * turn);
}

std::int64_t FixedMetric::ofPlace(const CellTotals& learned) const {
  const PairWeights& weights = metric_.weights;
  return fixed(learned.occupied * (weights[kUnsensed][kOccupied] - weights[kUnsensed][kUnsensed]) +
               learned.empty * (weights[kUnsensed][kEmpty] - weights[kUnsensed][kUnsensed]) +
               kGridCells * weights[kUnsensed][kUnsensed]);
}

std::int64_t FixedMetric::fixed(double points) const {
  return std::llround(std::clamp(points * scale_, -kMost, kMost));
}

}  // namespace place_memory::core
