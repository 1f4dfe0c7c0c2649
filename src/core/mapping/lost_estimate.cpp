#include "core/mapping/lost_estimate.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kLeast = 2e-4;
/// New ground may look like known ground for long, and is never more than a strong doubt.
constexpr double kMostDoubt = 0.6;
/// Set by hand after the counts of place_memory_mapping fit_lost (seeds from 100 on): what the fit
/// makes of the few scans of lost robots that are not silent holds nowhere else, and most robots
/// are carried less often.
constexpr LostModel kFitted{
    0.0015, {0.15, 1.0, 3.2, 6.0, 2.0, 6.0}, {1.0, 0.03, 0.5, 30.0, 2000.0}, {1.0, 0.2, 100.0}};

}  // namespace

LostEstimate::LostEstimate() : LostEstimate(kFitted) {}

double LostEstimate::drive(const Spot& spot, double way) {
  const double lifted = std::expm1(model_.lifted_per_metre * way) *
                        model_.readings[static_cast<std::size_t>(spot.readings)] *
                        model_.compass[static_cast<std::size_t>(spot.compass)];
  const double carried = lifted / (1.0 + lifted);
  lost_ += (1.0 - lost_) * carried;
  return carried;
}

void LostEstimate::see(ScanWitness witness) {
  double ratio = model_.ratios[static_cast<std::size_t>(witness)];
  if (witness == ScanWitness::kDoubts && lost_ >= kMostDoubt) ratio = 1.0;
  const double odds = lost_ / std::max(1.0 - lost_, kLeast) * ratio;
  lost_ = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
}

}  // namespace place_memory::core
