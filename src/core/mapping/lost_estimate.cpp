#include "core/mapping/lost_estimate.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kLeast = 1e-3;
/// New ground may look like known ground for long, and is never more than a strong doubt.
constexpr double kMostDoubt = 0.6;
/// Set by hand after the counts of place_memory_mapping fit_lost (seeds from 100 on): most scans of
/// lost robots there are silent, and what the fit makes of the few others holds nowhere else.
constexpr LostModel kFitted{0.0015, {0.15, 1.0, 3.2, 6.0, 2.0, 6.0}};

}  // namespace

LostEstimate::LostEstimate() : LostEstimate(kFitted) {}

void LostEstimate::update(ScanWitness witness, double way) {
  lost_ += (1.0 - lost_) * (1.0 - std::exp(-model_.lifted_per_metre * way));
  double ratio = model_.ratios[static_cast<std::size_t>(witness)];
  if (witness == ScanWitness::kDoubts && lost_ >= kMostDoubt) ratio = 1.0;
  const double odds = lost_ / std::max(1.0 - lost_, kLeast) * ratio;
  lost_ = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
}

}  // namespace place_memory::core
