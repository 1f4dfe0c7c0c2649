#include "training/calibration_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/recognize/ranking.h"
#include "training/ranking_fit.h"

namespace place_memory::training {
namespace {

using Regressors = Eigen::Matrix<double, std::tuple_size<core::CalibrationFeatures>::value, 1>;

core::PairCounts countsOf(const Features& features) {
  core::PairCounts counts{};
  Eigen::Index i = 0;
  for (auto& row : counts) {
    for (int& count : row) count = static_cast<int>(std::lround(features[i++]));
  }
  return counts;
}

/// The best match of a scan, as the calibration sees it.
struct Sample {
  Regressors regressors;
  bool right = false;
  bool known = false;  ///< one of the places is right, the best match or not
  bool judged = true;  ///< there is an occupied cell: without, the recognizer answers UNKNOWN
  double weight = 1.0;
};

/// The candidates, in this order, as the recognizer has the places of an index.
core::AlignedPlaces aligned(const std::vector<const Candidate*>& order, const CandidateList& list,
                            const Features& metric) {
  core::AlignedPlaces places;
  places.own = countsOf(list.own);
  places.cell_size = list.cell_size;
  for (const Candidate* candidate : order) {
    places.places.push_back({metric.dot(candidate->features), candidate->place_from_scan});
  }
  places.counts = [&order](std::size_t i) {
    return core::AlignmentCounts{countsOf(order[i]->features), order[i]->near, order[i]->sharpness};
  };
  places.frames = [&order](const std::vector<std::size_t>& numbers) {
    std::vector<core::PlaceFrame> frames;
    for (const std::size_t i : numbers) frames.push_back({order[i]->map_from_place});
    return std::optional(frames);
  };
  return places;
}

Sample sampleOf(const CandidateList& list, const RankingWeights& weights, double scale,
                double weight) {
  core::RecognizerOptions options;
  options.rescoring = weights.rescoring;
  options.calibration.scale = scale;
  const std::vector<const Candidate*> order = ranked(list, weights.metric);
  const core::Ranking ranking =
      core::rankPlaces(aligned(order, list, weights.metric), options).value();
  Sample sample;
  sample.regressors = Eigen::Map<const Regressors>(ranking.features.data());
  sample.right = order[ranking.places.front().number]->right;
  sample.known = std::any_of(order.begin(), order.end(),
                             [](const Candidate* candidate) { return candidate->right; });
  constexpr auto kOccupied = static_cast<std::size_t>(core::CellClass::kOccupied);
  sample.judged = countsOf(list.own)[kOccupied][kOccupied] > 0;
  sample.weight = weight;
  return sample;
}

std::vector<Sample> samplesOf(const CalibrationScans& scans, const RankingWeights& weights,
                              double scale) {
  std::vector<Sample> samples;
  const auto add = [&](const std::vector<CandidateList>& lists, double weight) {
    for (const CandidateList& list : lists) {
      if (list.candidates.empty()) continue;
      samples.push_back(sampleOf(list, weights, scale, weight / static_cast<double>(lists.size())));
    }
  };
  add(scans.known, scans.known_weight);
  add(scans.strangers, scans.strangers_weight);
  return samples;
}

double probabilityOf(const Sample& sample, const Regressors& coefficients) {
  if (!sample.judged) return 0.0;
  return 1.0 / (1.0 + std::exp(-coefficients.dot(sample.regressors)));
}

core::CalibrationFeatures fitLogistic(const std::vector<Sample>& samples, bool Sample::*holds) {
  constexpr int kSteps = 60;
  constexpr double kRidge = 1e-5;
  using Hessian =
      Eigen::Matrix<double, Regressors::RowsAtCompileTime, Regressors::RowsAtCompileTime>;
  Regressors coefficients = Regressors::Zero();
  for (int i = 0; i < kSteps; ++i) {
    Regressors gradient = kRidge * coefficients;
    Hessian hessian = kRidge * Hessian::Identity();
    for (const Sample& sample : samples) {
      if (!sample.judged) continue;
      const double p = probabilityOf(sample, coefficients);
      gradient += sample.weight * (p - (sample.*holds ? 1.0 : 0.0)) * sample.regressors;
      hessian += sample.weight * p * (1.0 - p) * sample.regressors * sample.regressors.transpose();
    }
    Regressors step = hessian.ldlt().solve(gradient);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > 2.0) step *= 2.0 / size;
    coefficients -= step;
  }
  core::CalibrationFeatures result;
  Eigen::Map<Regressors>(result.data()) = coefficients;
  return result;
}

}  // namespace

core::Calibration fitCalibration(const std::vector<CalibrationScans>& parts,
                                 const RankingWeights& weights) {
  core::Calibration calibration;
  // Re-scoring scores are in nats already: the weights are fitted on the search score's scale.
  if (!weights.rescoring) {
    calibration.scale = bestScale(searchChoices(parts.front().known), weights.metric);
  }
  std::vector<Sample> samples;
  for (const CalibrationScans& part : parts) {
    const std::vector<Sample> more = samplesOf(part, weights, calibration.scale);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  calibration.right = fitLogistic(samples, &Sample::right);
  calibration.known = fitLogistic(samples, &Sample::known);
  return calibration;
}

CalibrationReport reportCalibration(const std::vector<CandidateList>& known,
                                    const std::vector<CandidateList>& strangers,
                                    const RankingWeights& weights,
                                    const core::Calibration& calibration, double confidence) {
  constexpr std::size_t kBins = 10;
  struct Bin {
    double weight = 0.0, probability = 0.0, right = 0.0;
  };
  std::array<Bin, kBins> bins;
  const Regressors right = Eigen::Map<const Regressors>(calibration.right.data());
  const Regressors known_place = Eigen::Map<const Regressors>(calibration.known.data());
  CalibrationReport report;
  const std::size_t known_count = samplesOf({known, {}}, weights, calibration.scale).size();
  std::size_t index = 0;
  for (const Sample& sample : samplesOf({known, strangers}, weights, calibration.scale)) {
    const double p = probabilityOf(sample, right);
    Bin& bin = bins[std::min(static_cast<std::size_t>(p * kBins), kBins - 1)];
    bin.weight += sample.weight;
    bin.probability += sample.weight * p;
    bin.right += sample.right ? sample.weight : 0.0;
    const bool is_known = index++ < known_count;
    if (is_known && sample.right) report.top_one += sample.weight;
    if (p < confidence && probabilityOf(sample, known_place) < confidence) {
      (is_known ? report.missed : report.refused) += sample.weight;
    }
    if (p < confidence) continue;
    if (!is_known) report.accepted += sample.weight;
    if (is_known && sample.right) report.recognized += sample.weight;
    if (is_known && !sample.right) report.wrong += sample.weight;
  }
  double all = 0.0;
  for (const Bin& bin : bins) {
    report.calibration_error += std::abs(bin.probability - bin.right);
    all += bin.weight;
  }
  if (all > 0.0) report.calibration_error /= all;
  return report;
}

}  // namespace place_memory::training
