#include "training/calibration_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "place_memory/core/consensus.h"
#include "training/ranking_fit.h"

namespace place_memory::training {
namespace {

using Regressors = Eigen::Matrix<double, 6, 1>;

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
  Regressors regressors;  ///< 1, the four shares of agreement, log(1 + scale * lead)
  bool right = false;
  bool right_elsewhere = false;  ///< a place that is right is not the best match
  double weight = 1.0;
};

/// The candidates by falling score.
std::vector<const Candidate*> ranked(const CandidateList& list, const Features& weights) {
  std::vector<const Candidate*> order;
  for (const Candidate& candidate : list.candidates) order.push_back(&candidate);
  std::stable_sort(order.begin(), order.end(), [&](const Candidate* a, const Candidate* b) {
    return weights.dot(a->features) > weights.dot(b->features);
  });
  return order;
}

Sample sampleOf(const CandidateList& list, const Features& weights, double scale, double weight) {
  const std::vector<const Candidate*> order = ranked(list, weights);
  std::vector<core::Opinion> opinions;
  bool any_right = false;
  for (const Candidate* candidate : order) {
    const core::Pose2d& pose = candidate->place_from_scan;
    opinions.push_back(
        {weights.dot(candidate->features), std::hypot(pose.x, pose.y), candidate->map_from_scan});
    any_right = any_right || candidate->right;
  }
  const core::Consensus consensus = core::findConsensus(opinions, list.cell_size);
  const Candidate& match = *order[consensus.chosen];
  const double lead = opinions[consensus.chosen].score - consensus.runner_up;
  const core::Agreement shares = core::agreementOf(countsOf(match.features), countsOf(list.own));
  Sample sample;
  sample.regressors << 1.0, shares[0][0], shares[0][1], shares[1][0], shares[1][1],
      std::log1p(scale * std::max(lead, 0.0));
  sample.right = match.right;
  sample.right_elsewhere = any_right && !match.right;
  sample.weight = weight;
  return sample;
}

std::vector<Sample> samplesOf(const std::vector<CandidateList>& known,
                              const std::vector<CandidateList>& strangers, const Features& weights,
                              double scale) {
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

Regressors fitLogistic(const std::vector<Sample>& samples) {
  constexpr int kSteps = 60;
  constexpr double kRidge = 1e-5;
  Regressors coefficients = Regressors::Zero();
  for (int i = 0; i < kSteps; ++i) {
    Regressors gradient = kRidge * coefficients;
    Eigen::Matrix<double, 6, 6> hessian = kRidge * Eigen::Matrix<double, 6, 6>::Identity();
    for (const Sample& sample : samples) {
      const double p = probabilityOf(sample, coefficients);
      gradient += sample.weight * (p - (sample.right ? 1.0 : 0.0)) * sample.regressors;
      hessian += sample.weight * p * (1.0 - p) * sample.regressors * sample.regressors.transpose();
    }
    Regressors step = hessian.ldlt().solve(gradient);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > 2.0) step *= 2.0 / size;
    coefficients -= step;
  }
  coefficients[5] = std::max(coefficients[5], 0.0);
  return coefficients;
}

}  // namespace

core::Calibration fitCalibration(const std::vector<CandidateList>& known,
                                 const std::vector<CandidateList>& strangers,
                                 const Features& weights) {
  core::Calibration calibration;
  calibration.scale = bestScale(known, weights);
  const std::vector<Sample> samples = samplesOf(known, strangers, weights, calibration.scale);
  const Regressors coefficients = fitLogistic(samples);
  calibration.bias = coefficients[0];
  calibration.shares = {{{coefficients[1], coefficients[2]}, {coefficients[3], coefficients[4]}}};
  calibration.margin = coefficients[5];
  double wrong = 0.0, elsewhere = 0.0;
  for (const Sample& sample : samples) {
    wrong += sample.right ? 0.0 : sample.weight;
    elsewhere += sample.right_elsewhere ? sample.weight : 0.0;
  }
  calibration.others = wrong > 0.0 ? elsewhere / wrong : 0.0;
  return calibration;
}

CalibrationReport reportCalibration(const std::vector<CandidateList>& known,
                                    const std::vector<CandidateList>& strangers,
                                    const Features& weights, const core::Calibration& calibration,
                                    double confidence) {
  constexpr std::size_t kBins = 10;
  struct Bin {
    double weight = 0.0, probability = 0.0, right = 0.0;
  };
  std::array<Bin, kBins> bins;
  const auto& shares = calibration.shares;
  Regressors coefficients;
  coefficients << calibration.bias, shares[0][0], shares[0][1], shares[1][0], shares[1][1],
      calibration.margin;
  CalibrationReport report;
  const std::size_t known_count = samplesOf(known, {}, weights, calibration.scale).size();
  std::size_t index = 0;
  for (const Sample& sample : samplesOf(known, strangers, weights, calibration.scale)) {
    const double p = probabilityOf(sample, coefficients);
    Bin& bin = bins[std::min(static_cast<std::size_t>(p * kBins), kBins - 1)];
    bin.weight += sample.weight;
    bin.probability += sample.weight * p;
    bin.right += sample.right ? sample.weight : 0.0;
    const bool is_known = index++ < known_count;
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
