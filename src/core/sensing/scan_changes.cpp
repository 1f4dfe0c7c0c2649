#include "core/sensing/scan_changes.h"

#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kPassedCounts = 2.0;  // times as much as in other grids

double logOdds(double probability) { return std::log(probability / (1.0 - probability)); }

SonarModelOptions sonarOfChanges(SonarModelOptions sonar) {
  const double prior = logOdds(sonar.prior);
  const double empty = prior + kPassedCounts * (logOdds(sonar.empty) - prior);
  sonar.empty = 1.0 / (1.0 + std::exp(-empty));
  return sonar;
}

}  // namespace

std::vector<GridChange> changesBetween(const std::vector<SonarReading>& before,
                                       const std::vector<SonarReading>& now,
                                       const SonarModelOptions& sonar, const GridGeometry& geometry,
                                       const GridChangeOptions& options) {
  const SonarModel model(sonarOfChanges(sonar));
  return changesBetween(model.build(before, geometry), model.build(now, geometry), options);
}

}  // namespace place_memory::core
