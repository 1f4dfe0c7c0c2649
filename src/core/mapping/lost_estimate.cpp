#include "core/mapping/lost_estimate.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kLiftedPerMetre = 0.001;
constexpr double kLeast = 1e-4;
/// Likelihood ratios of whole new scans, lost to not lost: measured on simulated drives, softened.
constexpr double kAgrees = 0.003;
constexpr double kMisses = 30.0;
constexpr double kElsewhere = 300.0;

}  // namespace

void LostEstimate::update(ScanWitness witness, double share, double way) {
  lost_ += (1.0 - lost_) * (1.0 - std::exp(-kLiftedPerMetre * way));
  double ratio = 1.0;
  if (witness == ScanWitness::kAgrees) ratio = kAgrees;
  if (witness == ScanWitness::kMisses) ratio = kMisses;
  if (witness == ScanWitness::kElsewhere) ratio = kElsewhere;
  const double odds = lost_ / std::max(1.0 - lost_, kLeast) * std::pow(ratio, share);
  lost_ = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
}

}  // namespace place_memory::core
