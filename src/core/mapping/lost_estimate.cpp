#include "core/mapping/lost_estimate.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kLeast = 1e-3;
constexpr LostModel kFitted{0.001, {0.1, 1.0, 3.2, 5.0, 1.5, 10.0}};

}  // namespace

LostEstimate::LostEstimate() : LostEstimate(kFitted) {}

void LostEstimate::update(ScanWitness witness, double way) {
  lost_ += (1.0 - lost_) * (1.0 - std::exp(-model_.lifted_per_metre * way));
  const double ratio = model_.ratios[static_cast<std::size_t>(witness)];
  const double odds = lost_ / std::max(1.0 - lost_, kLeast) * ratio;
  lost_ = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
}

}  // namespace place_memory::core
