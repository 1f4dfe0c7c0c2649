#ifndef PLACE_MEMORY_CORE_RECOGNIZE_RANKING_H
#define PLACE_MEMORY_CORE_RECOGNIZE_RANKING_H

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/recognize/hypothesis_cluster.h"
#include "core/recognize/place_frame.h"
#include "core/recognize/scan_query.h"
#include "place_memory/core/calibration.h"
#include "place_memory/core/recognizer_options.h"

namespace place_memory::core {

/// A place at the alignment that a search found for it.
struct AlignedPlace {
  double search_score = 0.0;
  Pose2d place_from_scan;  ///< the alignment
};

/// Aligned places by falling search score, and what ranking asks for of some of them, each named by
/// its number among them.
struct AlignedPlaces {
  std::vector<AlignedPlace> places;  ///< at least one
  PairCounts own{};                  ///< of the scan with itself
  double cell_size = 0.0;            ///< [m]
  std::function<AlignmentCounts(std::size_t)> counts;
  /// Nothing where one of them is gone.
  std::function<std::optional<std::vector<PlaceFrame>>(const std::vector<std::size_t>&)> frames;
};

struct RankedPlace {
  std::size_t number = 0;  ///< among the aligned places
  double search_score = 0.0;
  std::optional<double> rescoring_score;  ///< of the foremost, where there is a re-scoring
  /// By which it is ranked: the re-scoring's where there is one, else the search's; places beyond
  /// the foremost as combineScores() has them.
  double score = 0.0;
};

/// The places of one answer, and what its verdict is made of.
struct Ranking {
  std::vector<RankedPlace> places;  ///< the chosen one first, the others by falling score
  HypothesisCluster cluster;
  PlaceFrame frame;  ///< of the chosen one
  CalibrationFeatures features{};
};

/// What follows the search, for recognizing and for fitting alike: re-scores the foremost places,
/// clusters their hypotheses, and takes the features of the calibration. Nothing where a place is
/// gone.
std::optional<Ranking> rankPlaces(const AlignedPlaces& aligned, const RecognizerOptions& options);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_RANKING_H
