#include "training/calibration_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/recognize/consensus.h"
#include "training/ranking_fit.h"

namespace place_memory::training {
namespace {

using Regressors = Eigen::Matrix<double, std::tuple_size<core::Support>::value, 1>;

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
  double weight = 1.0;
};

/// The candidates as the recognizer ranks them, with their scores.
struct Ranking {
  std::vector<const Candidate*> order;
  std::vector<double> scores;
};

Ranking rankingOf(const CandidateList& list, const RankingWeights& weights) {
  Ranking ranking{ranked(list, weights.metric), {}};
  for (const Candidate* candidate : ranking.order) {
    ranking.scores.push_back(weights.metric.dot(candidate->features));
  }
  if (!weights.second_look) return ranking;
  std::vector<double> again;
  for (std::size_t i = 0; i < std::min(ranking.order.size(), core::kLookedAtAgain); ++i) {
    again.push_back(core::scoreAgain(ranking.scores[i], ranking.order[i]->closely,
                                     ranking.order[i]->falloff, *weights.second_look));
  }
  const std::vector<double> scores = core::combineLooks(ranking.scores, again);
  std::vector<std::size_t> by_score(scores.size());
  std::iota(by_score.begin(), by_score.end(), 0U);
  std::stable_sort(by_score.begin(), by_score.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  Ranking anew;
  for (const std::size_t i : by_score) {
    anew.order.push_back(ranking.order[i]);
    anew.scores.push_back(scores[i]);
  }
  return anew;
}

Sample sampleOf(const CandidateList& list, const RankingWeights& weights, double scale,
                double weight) {
  const Ranking ranking = rankingOf(list, weights);
  Sample sample;
  std::vector<core::Opinion> opinions;
  for (std::size_t i = 0; i < ranking.order.size(); ++i) {
    const Candidate& candidate = *ranking.order[i];
    const core::Pose2d& pose = candidate.place_from_scan;
    opinions.push_back({ranking.scores[i], std::hypot(pose.x, pose.y), candidate.odom_from_scan});
    sample.known = sample.known || candidate.right;
  }
  const core::Consensus consensus = core::findConsensus(opinions, list.cell_size);
  const Candidate& match = *ranking.order[consensus.chosen];
  const core::Support support =
      core::supportOf(countsOf(match.features), match.closely, countsOf(list.own), consensus,
                      list.candidates.size(), scale);
  sample.regressors = Eigen::Map<const Regressors>(support.data());
  sample.right = match.right;
  sample.weight = weight;
  return sample;
}

std::vector<Sample> samplesOf(const std::vector<CandidateList>& known,
                              const std::vector<CandidateList>& strangers,
                              const RankingWeights& weights, double scale) {
  std::vector<Sample> samples;
  const auto add = [&](const std::vector<CandidateList>& lists) {
    for (const CandidateList& list : lists) {
      if (list.candidates.empty()) continue;
      samples.push_back(sampleOf(list, weights, scale, 1.0 / static_cast<double>(lists.size())));
    }
  };
  add(known);
  add(strangers);
  return samples;
}

double probabilityOf(const Sample& sample, const Regressors& coefficients) {
  return 1.0 / (1.0 + std::exp(-coefficients.dot(sample.regressors)));
}

core::Support fitLogistic(const std::vector<Sample>& samples, bool Sample::*holds) {
  constexpr int kSteps = 60;
  constexpr double kRidge = 1e-5;
  using Hessian =
      Eigen::Matrix<double, Regressors::RowsAtCompileTime, Regressors::RowsAtCompileTime>;
  Regressors coefficients = Regressors::Zero();
  for (int i = 0; i < kSteps; ++i) {
    Regressors gradient = kRidge * coefficients;
    Hessian hessian = kRidge * Hessian::Identity();
    for (const Sample& sample : samples) {
      const double p = probabilityOf(sample, coefficients);
      gradient += sample.weight * (p - (sample.*holds ? 1.0 : 0.0)) * sample.regressors;
      hessian += sample.weight * p * (1.0 - p) * sample.regressors * sample.regressors.transpose();
    }
    Regressors step = hessian.ldlt().solve(gradient);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > 2.0) step *= 2.0 / size;
    coefficients -= step;
  }
  core::Support result;
  Eigen::Map<Regressors>(result.data()) = coefficients;
  return result;
}

}  // namespace

core::Calibration fitCalibration(const std::vector<CandidateList>& known,
                                 const std::vector<CandidateList>& strangers,
                                 const RankingWeights& weights) {
  core::Calibration calibration;
  // A second look's scores are in nats already: it is fitted on the scale of its first look.
  if (!weights.second_look) calibration.scale = bestScale(firstChoices(known), weights.metric);
  const std::vector<Sample> samples = samplesOf(known, strangers, weights, calibration.scale);
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
  const std::size_t known_count = samplesOf(known, {}, weights, calibration.scale).size();
  std::size_t index = 0;
  for (const Sample& sample : samplesOf(known, strangers, weights, calibration.scale)) {
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
