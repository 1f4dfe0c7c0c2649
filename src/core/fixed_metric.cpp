#include "fixed_metric.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

/// Points below this share of the largest weight are left to rounding, so that sums fit.
constexpr double kLeastShare = 1e-6;
/// Sums of three stay below 2^63.
constexpr double kMost = 1LL << 60;

}  // namespace

FixedMetric::FixedMetric(const LatticeMetric& metric) : metric_(metric), linear_(metric.weights) {
  double most = std::max({std::abs(linear_.occupied_occupied), std::abs(linear_.occupied_empty),
                          std::abs(linear_.empty_occupied), std::abs(linear_.empty_empty)});
  for (const auto& row : metric.weights) {
    for (const double weight : row) most = std::max(most, kLeastShare * std::abs(weight));
  }
  if (most > 0.0) scale_ = std::exp2(30.0) / (kMostShare * most);
}

PairFactors FixedMetric::factors(const PairShares& shares) const {
  const auto factor = [this](double points, double share) {
    return static_cast<std::int32_t>(fixed(points * share));
  };
  return {factor(linear_.occupied_occupied, shares.occupied_occupied),
          factor(linear_.occupied_empty, shares.occupied_empty),
          factor(linear_.empty_occupied, shares.empty_occupied),
          factor(linear_.empty_empty, shares.empty_empty)};
}

std::int64_t FixedMetric::ofTransform(const CellTotals& inside, CellShift shift, int turn) const {
  const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
  return fixed(inside.occupied * linear_.occupied + inside.empty * linear_.empty -
               metric_.shift_cost * cells - metric_.turn_cost * turn * turn);
}

std::int64_t FixedMetric::ofPlace(const CellTotals& learned) const {
  return fixed(learned.occupied * linear_.learned_occupied + learned.empty * linear_.learned_empty +
               linear_.unsensed);
}

std::int64_t FixedMetric::fixed(double points) const {
  const double scaled = std::clamp(points * scale_, -kMost, kMost);
  // To the nearest, without a call of the library: very many transforms have one.
  return static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
}

}  // namespace place_memory::core
