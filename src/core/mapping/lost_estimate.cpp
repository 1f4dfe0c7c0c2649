#include "core/mapping/lost_estimate.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kLiftedPerMetre = 0.001;
constexpr double kLeast = 1e-3;
/// Likelihood ratios, lost to not lost. A scan that should agree fails to one time in ten, hardly
/// ever four times in a row; neighbouring scans share readings, so the ratios are softened.
constexpr double kAgrees = 0.1;
constexpr double kMisses = 4.0;
/// Corridors look alike some metres on, and new ones like known ones.
constexpr double kDoubts = 3.0;
constexpr double kElsewhere = 10.0;

}  // namespace

void LostEstimate::update(ScanWitness witness, double way) {
  lost_ += (1.0 - lost_) * (1.0 - std::exp(-kLiftedPerMetre * way));
  double ratio = 1.0;
  if (witness == ScanWitness::kAgrees) ratio = kAgrees;
  if (witness == ScanWitness::kMisses) ratio = kMisses;
  if (witness == ScanWitness::kDoubts) ratio = kDoubts;
  if (witness == ScanWitness::kElsewhere) ratio = kElsewhere;
  const double odds = lost_ / std::max(1.0 - lost_, kLeast) * ratio;
  lost_ = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
}

}  // namespace place_memory::core
