#ifndef PLACE_MEMORY_CORE_CALIBRATION_H
#define PLACE_MEMORY_CORE_CALIBRATION_H

#include <array>
#include <cstddef>

namespace place_memory::core {

/// The features of the calibration: what speaks for the best match and against it. These are the
/// names of their coefficients in preset files.
constexpr std::array<const char*, 23> kCalibrationFeatureNames{
    "bias",                  // 1
    "empty_on_empty",        // share of the scan's empty cells that fall on learned empty ones
    "empty_on_occupied",     // likewise on occupied ones
    "occupied_on_empty",     // share of the scan's occupied cells that fall on learned empty ones
    "occupied_on_occupied",  // likewise on occupied ones
    "occupied_within_one",   // likewise up to one cell from occupied ones
    "occupied_within_two",   // up to two cells
    "empty_by_occupied",     // share of the empty cells up to one cell from learned occupied ones
    "learned_occupied_on_empty",     // share of the learned occupied cells on which empty ones fall
    "learned_occupied_on_occupied",  // likewise occupied ones
    "learned_empty_on_occupied",     // share of the learned empty cells on which occupied ones fall
    "margin",                        // log(1 + scale * margin over the best other hypothesis)
    "mean_margin",                   // scale * margin over the mean of the other hypotheses
    "unopposed",                     // scale * score, where there is no other hypothesis
    "inverse_place_count",           // 1 / number of places: a margin over few says little
    // How much there is to go by: few cells agree by chance, and a lone wall fits any other.
    "occupied_cells",              // log(1 + the scan's)
    "learned_occupied_cells",      // log(1 + the learned ones)
    "cells_within_one",            // log(1 + the scan's up to one cell from learned ones)
    "cells_within_one_squared",    // the square of that
    "occupied_per_empty",          // log((1 + the scan's occupied cells) / (1 + its empty ones))
    "learned_occupied_per_empty",  // likewise of the learned ones
    "fall_by_shift",               // log(1 + scale * how far the search's score falls by a shift)
    "fall_by_rotation",            // likewise by a rotation
};
/// So many of them a preset file must name; those added since are 0 where it does not.
constexpr std::size_t kFirstCalibrationFeatures = 15;
using CalibrationFeatures = std::array<double, kCalibrationFeatureNames.size()>;

/// From scores to probabilities, by logistic regression (Platt, Probabilistic Outputs for Support
/// Vector Machines, 1999). Log odds are the sum of coefficients times features. What the
/// probability that the scan is of a known place exceeds that of the best match by goes to the
/// other places, in proportion to exp(scale * score), but to none more than the best has.
struct Calibration {
  double scale = 1.0;  ///< [1 / score], > 0
  /// Of the log odds that the best match is right.
  CalibrationFeatures right{-6.0, 2.0, -5.0, -5.0, 5.0, 0.0, 0.0, 0.0,
                            0.0,  0.0, 0.0,  1.0,  0.0, 0.0, 0.0};
  /// Of those that the scan is of any place of the memory.
  CalibrationFeatures known{-4.0, 2.0, -5.0, -5.0, 5.0, 0.0, 0.0, 0.0,
                            0.0,  0.0, 0.0,  0.0,  0.0, 0.0, 0.0};
  /// How sharply a pose's likelihood falls with its score, for the pose's covariance [1 / score],
  /// >= 0.
  double sharpness = 0.1;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_CALIBRATION_H
