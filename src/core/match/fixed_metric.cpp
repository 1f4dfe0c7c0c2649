#include "core/match/fixed_metric.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

/// Points below this share of the largest weight are left to rounding, so that sums fit.
constexpr double kLeastShare = 1e-6;

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

std::int64_t FixedMetric::ofPlace(const CellTotals& learned) const {
  return fixed(learned.occupied * linear_.learned_occupied + learned.empty * linear_.learned_empty +
               linear_.unsensed);
}

}  // namespace place_memory::core
