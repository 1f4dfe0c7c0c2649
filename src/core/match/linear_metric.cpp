#include "core/match/linear_metric.h"

#include "place_memory/core/grid_geometry.h"

namespace place_memory::core {
namespace {

constexpr auto kEmpty = static_cast<std::size_t>(CellClass::kEmpty);
constexpr auto kUnsensed = static_cast<std::size_t>(CellClass::kUnsensed);
constexpr auto kOccupied = static_cast<std::size_t>(CellClass::kOccupied);

/// What a pair earns beside what each of its cells does.
double together(const PairWeights& weights, std::size_t recognition, std::size_t learned) {
  return weights[recognition][learned] - weights[recognition][kUnsensed] -
         weights[kUnsensed][learned] + weights[kUnsensed][kUnsensed];
}

}  // namespace

LinearMetric::LinearMetric(const PairWeights& weights)
    : occupied_occupied(together(weights, kOccupied, kOccupied)),
      occupied_empty(together(weights, kOccupied, kEmpty)),
      empty_occupied(together(weights, kEmpty, kOccupied)),
      empty_empty(together(weights, kEmpty, kEmpty)),
      occupied(weights[kOccupied][kUnsensed] - weights[kUnsensed][kUnsensed]),
      empty(weights[kEmpty][kUnsensed] - weights[kUnsensed][kUnsensed]),
      learned_occupied(weights[kUnsensed][kOccupied] - weights[kUnsensed][kUnsensed]),
      learned_empty(weights[kUnsensed][kEmpty] - weights[kUnsensed][kUnsensed]),
      unsensed(kGridCells * weights[kUnsensed][kUnsensed]) {}

}  // namespace place_memory::core
