#include "core/recognize/verdict.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace place_memory::core {
namespace {

double probabilityOf(const CalibrationFeatures& coefficients, const CalibrationFeatures& features) {
  const double log_odds =
      std::inner_product(features.begin(), features.end(), coefficients.begin(), 0.0);
  return 1.0 / (1.0 + std::exp(-log_odds));
}

/// Splits `rest` among all matches but the first; none gets more than that has.
void shareAmongOthers(double rest, double scale, std::vector<PlaceMatch>& matches) {
  double all = 0.0;
  double best = matches[1].score;
  for (std::size_t i = 2; i < matches.size(); ++i) best = std::max(best, matches[i].score);
  const auto weight = [&](const PlaceMatch& match) {
    return std::exp(scale * (match.score - best));
  };
  for (std::size_t i = 1; i < matches.size(); ++i) all += weight(matches[i]);
  rest = std::min(rest, matches.front().probability * all);  // the heaviest weighs 1
  for (std::size_t i = 1; i < matches.size(); ++i) {
    matches[i].probability = rest * weight(matches[i]) / all;
  }
}

}  // namespace

CalibrationFeatures calibrationFeatures(const AlignmentCounts& counts, const PairCounts& own,
                                        const HypothesisCluster& cluster, std::size_t places,
                                        double scale) {
  const PairCounts& at = counts.pairs;
  const RescoringCounts& near = counts.near;
  constexpr auto kEmpty = static_cast<std::size_t>(CellClass::kEmpty);
  constexpr auto kOccupied = static_cast<std::size_t>(CellClass::kOccupied);
  const auto ratio = [](int cells, int of) {
    return of == 0 ? 0.0 : static_cast<double>(cells) / of;
  };
  const auto share = [&](int cells, std::size_t of) { return ratio(cells, own[of][of]); };
  const auto learned = [&](std::size_t of) { return at[0][of] + at[1][of] + at[2][of]; };
  const double within_one = std::log1p(near.of(NearPairs::kOccupiedWithinOne));
  const double own_occupied = std::log1p(own[kOccupied][kOccupied]);
  const double learned_occupied = std::log1p(learned(kOccupied));
  return {1.0,
          share(at[kEmpty][kEmpty], kEmpty),
          share(at[kEmpty][kOccupied], kEmpty),
          share(at[kOccupied][kEmpty], kOccupied),
          share(at[kOccupied][kOccupied], kOccupied),
          share(near.of(NearPairs::kOccupiedWithinOne), kOccupied),
          share(near.of(NearPairs::kOccupiedWithinTwo), kOccupied),
          share(near.of(NearPairs::kEmptyByOccupied), kEmpty),
          ratio(at[kEmpty][kOccupied], learned(kOccupied)),
          ratio(at[kOccupied][kOccupied], learned(kOccupied)),
          ratio(at[kOccupied][kEmpty], learned(kEmpty)),
          std::log1p(scale * std::max(cluster.margin, 0.0)),
          scale * cluster.mean_margin,
          scale * cluster.unopposed,
          1.0 / static_cast<double>(std::max<std::size_t>(places, 1)),
          own_occupied,
          learned_occupied,
          within_one,
          within_one * within_one,
          own_occupied - std::log1p(own[kEmpty][kEmpty]),
          learned_occupied - std::log1p(learned(kEmpty)),
          std::log1p(scale * std::max(-counts.sharpness.shift, 0.0)),
          std::log1p(scale * std::max(-counts.sharpness.rotation, 0.0))};
}

void judge(const CalibrationFeatures& features, const Calibration& calibration, double confidence,
           Recognition& recognition) {
  std::vector<PlaceMatch>& matches = recognition.matches;
  recognition.verdict = Verdict::kUnknown;
  if (matches.empty()) return;
  const double right = probabilityOf(calibration.right, features);
  const double known = std::max(right, probabilityOf(calibration.known, features));
  matches.front().probability = right;
  if (matches.size() > 1) shareAmongOthers(known - right, calibration.scale, matches);
  if (right >= confidence) {
    recognition.verdict = Verdict::kRecognized;
  } else if (matches.size() > 1 && known >= confidence) {
    recognition.verdict = Verdict::kAmbiguous;
  }
}

}  // namespace place_memory::core
