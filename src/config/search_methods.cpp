#include "config/search_methods.h"

#include <algorithm>
#include <stdexcept>

namespace place_memory::config {

const std::vector<std::pair<std::string, core::SearchMethod>>& searchMethods() {
  static const std::vector<std::pair<std::string, core::SearchMethod>> kMethods{
      {"nearest_neighbour", core::SearchMethod::kNearestNeighbour},
      {"hill_climbing", core::SearchMethod::kHillClimbing},
      {"restarts", core::SearchMethod::kRestarts},
      {"exhaustive", core::SearchMethod::kExhaustive}};
  return kMethods;
}

const std::string& wordFor(core::SearchMethod method) {
  const auto& methods = searchMethods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const auto& known) { return known.second == method; });
  if (found == methods.end()) throw std::invalid_argument("there is no such search method");
  return found->first;
}

}  // namespace place_memory::config
