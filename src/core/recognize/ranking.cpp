#include "core/recognize/ranking.h"

#include <algorithm>
#include <cmath>

#include "core/recognize/verdict.h"

namespace place_memory::core {
namespace {

/// The places in the search's order.
std::vector<RankedPlace> inSearchOrder(const AlignedPlaces& aligned) {
  std::vector<RankedPlace> places;
  places.reserve(aligned.places.size());
  for (const AlignedPlace& place : aligned.places) {
    places.push_back({places.size(), place.search_score, std::nullopt, place.search_score});
  }
  return places;
}

/// Ranks anew by re-scoring. `counts` are those of the foremost places.
void rankAnew(const std::vector<AlignmentCounts>& counts, const RescoringWeights& weights,
              std::vector<RankedPlace>& places) {
  std::vector<double> search, rescored;
  search.reserve(places.size());
  for (RankedPlace& place : places) {
    search.push_back(place.search_score);
    if (rescored.size() == counts.size()) continue;
    const AlignmentCounts& of_place = counts[rescored.size()];
    place.rescoring_score = rescore(place.search_score, of_place.near, of_place.sharpness, weights);
    rescored.push_back(*place.rescoring_score);
  }
  const std::vector<double> scores = combineScores(search, rescored);
  for (std::size_t i = 0; i < places.size(); ++i) places[i].score = scores[i];
  const auto foremost = places.begin() + static_cast<std::ptrdiff_t>(counts.size());
  std::stable_sort(places.begin(), foremost,
                   [](const RankedPlace& a, const RankedPlace& b) { return a.score > b.score; });
}

std::vector<PoseHypothesis> hypothesesOf(const std::vector<RankedPlace>& places,
                                         const AlignedPlaces& aligned,
                                         const std::vector<PlaceFrame>& frames, bool located) {
  std::vector<PoseHypothesis> hypotheses;
  hypotheses.reserve(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Pose2d& place_from_scan = aligned.places[places[i].number].place_from_scan;
    hypotheses.push_back({places[i].score, std::hypot(place_from_scan.x, place_from_scan.y),
                          std::nullopt, frames[i].session});
    if (located) hypotheses.back().map_from_scan = frames[i].map_from_place * place_from_scan;
  }
  return hypotheses;
}

}  // namespace

std::optional<Ranking> rankPlaces(const AlignedPlaces& aligned, const RecognizerOptions& options) {
  Ranking ranking;
  ranking.places = inSearchOrder(aligned);
  std::vector<AlignmentCounts> counts;
  if (options.rescoring) {
    for (std::size_t i = 0; i < std::min(ranking.places.size(), kRescored); ++i) {
      counts.push_back(aligned.counts(i));
    }
    rankAnew(counts, *options.rescoring, ranking.places);
  }
  std::vector<std::size_t> foremost;
  for (std::size_t i = 0; i < std::min(ranking.places.size(), kMostHypotheses); ++i) {
    foremost.push_back(ranking.places[i].number);
  }
  const auto frames = aligned.frames(foremost);
  if (!frames) return std::nullopt;
  ranking.cluster = clusterHypotheses(
      hypothesesOf(ranking.places, aligned, *frames, options.located), aligned.cell_size);
  ranking.frame = (*frames)[ranking.cluster.chosen];
  const auto chosen = ranking.places.begin() + static_cast<std::ptrdiff_t>(ranking.cluster.chosen);
  std::rotate(ranking.places.begin(), chosen, chosen + 1);

  const std::size_t best = ranking.places.front().number;
  const AlignmentCounts at = best < counts.size() ? counts[best] : aligned.counts(best);
  ranking.features = calibrationFeatures(at, aligned.own, ranking.cluster, ranking.places.size(),
                                         options.calibration.scale);
  return ranking;
}

}  // namespace place_memory::core
