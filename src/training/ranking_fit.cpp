#include "training/ranking_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace place_memory::training {
namespace {

using Matrix = Eigen::Matrix<double, kFeatures, kFeatures>;

constexpr int kMostSteps = 50;
constexpr double kLeastGain = 1e-7;  ///< of the loss, for one more step

/// Softmax shares of the candidates, and of the right ones among themselves.
struct Shares {
  Eigen::VectorXd all;
  Eigen::VectorXd right;
  double right_share = 0.0;
};

Shares sharesOf(const CandidateList& list, const Features& weights) {
  const auto n = static_cast<Eigen::Index>(list.candidates.size());
  Shares shares{Eigen::VectorXd(n), Eigen::VectorXd(n), 0.0};
  for (Eigen::Index i = 0; i < n; ++i) {
    shares.all[i] = weights.dot(list.candidates[static_cast<std::size_t>(i)].features);
  }
  shares.all = (shares.all.array() - shares.all.maxCoeff()).exp();
  shares.all /= shares.all.sum();
  for (Eigen::Index i = 0; i < n; ++i) {
    shares.right[i] = list.candidates[static_cast<std::size_t>(i)].at_truth ? shares.all[i] : 0.0;
  }
  shares.right_share = shares.right.sum();
  if (shares.right_share > 0.0) shares.right /= shares.right_share;
  return shares;
}

bool hasRight(const CandidateList& list) {
  return std::any_of(list.candidates.begin(), list.candidates.end(),
                     [](const Candidate& candidate) { return candidate.at_truth; });
}

/// Standard deviation of each feature over all candidates; 1 where it is 0.
Features spreadOf(const std::vector<CandidateList>& lists) {
  Features sum = Features::Zero(), squares = Features::Zero();
  double n = 0.0;
  for (const CandidateList& list : lists) {
    for (const Candidate& candidate : list.candidates) {
      sum += candidate.features;
      squares += candidate.features.cwiseAbs2();
      n += 1.0;
    }
  }
  Features spread = (squares / n - (sum / n).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return spread.unaryExpr([](double s) { return s > 0.0 ? s : 1.0; });
}

class Objective {
 public:
  Objective(const std::vector<CandidateList>& lists, const Features& prior, double ridge)
      : lists_(lists), prior_(prior), curve_(2.0 * ridge * spreadOf(lists).cwiseAbs2()) {}

  double at(const Features& weights) const {
    return rankingLoss(lists_, weights) + 0.5 * (weights - prior_).cwiseAbs2().dot(curve_);
  }

  Features newtonStep(const Features& weights) const {
    Features gradient = Features::Zero();
    Matrix hessian = Matrix::Zero();
    double n = 0.0;
    for (const CandidateList& list : lists_) {
      if (!hasRight(list)) continue;
      n += list.weight;
      addTrial(list, weights, gradient, hessian);
    }
    gradient = gradient / n + (weights - prior_).cwiseProduct(curve_);
    hessian = hessian / n;
    // The part of the right candidates' spread is left out, so that the matrix stays positive.
    hessian.diagonal() += curve_ + Features::Constant(1e-12);
    return hessian.ldlt().solve(gradient);
  }

 private:
  static void addTrial(const CandidateList& list, const Features& weights, Features& gradient,
                       Matrix& hessian) {
    const Shares shares = sharesOf(list, weights);
    Features mean = Features::Zero(), right_mean = Features::Zero();
    Matrix second = Matrix::Zero();
    for (Eigen::Index i = 0; i < shares.all.size(); ++i) {
      const Features& f = list.candidates[static_cast<std::size_t>(i)].features;
      mean += shares.all[i] * f;
      right_mean += shares.right[i] * f;
      second += shares.all[i] * f * f.transpose();
    }
    gradient += list.weight * (mean - right_mean);
    hessian += list.weight * (second - mean * mean.transpose());
  }

  const std::vector<CandidateList>& lists_;
  Features prior_;
  Features curve_;
};

Features withinBounds(Features weights) {
  weights.tail<2>() = weights.tail<2>().cwiseMin(0.0);
  return weights;
}

}  // namespace

double rankingLoss(const std::vector<CandidateList>& lists, const Features& weights) {
  constexpr double kLeastShare = 1e-12;
  double loss = 0.0, n = 0.0;
  for (const CandidateList& list : lists) {
    if (!hasRight(list)) continue;
    loss -= list.weight * std::log(std::max(sharesOf(list, weights).right_share, kLeastShare));
    n += list.weight;
  }
  return n > 0.0 ? loss / n : 0.0;
}

double bestScale(const std::vector<CandidateList>& lists, const Features& weights) {
  double best = 1.0, least = INFINITY;
  for (double exponent = -6.0; exponent <= 2.0; exponent += 0.125) {
    const double scale = std::exp2(exponent);
    const double loss = rankingLoss(lists, scale * weights);
    if (loss < least) {
      least = loss;
      best = scale;
    }
  }
  return best;
}

Features fitRanking(const std::vector<CandidateList>& lists, const Features& prior, double ridge) {
  const Features start = withinBounds(prior);
  const Features scaled = bestScale(lists, start) * start;
  const Objective objective(lists, scaled, ridge);
  Features weights = scaled;
  double loss = objective.at(weights);
  for (int i = 0; i < kMostSteps; ++i) {
    const Features step = objective.newtonStep(weights);
    double gain = 0.0;
    for (double share = 1.0; share > 1e-4 && gain <= 0.0; share *= 0.5) {
      const Features next = withinBounds(weights - share * step);
      gain = loss - objective.at(next);
      if (gain > 0.0) weights = next;
    }
    loss -= std::max(gain, 0.0);
    if (gain < kLeastGain) break;
  }
  return weights;
}

double topOne(const std::vector<CandidateList>& lists, const Features& weights) {
  double right = 0.0, n = 0.0;
  for (const CandidateList& list : lists) {
    if (!hasRight(list)) continue;
    const auto best = std::max_element(list.candidates.begin(), list.candidates.end(),
                                       [&](const Candidate& a, const Candidate& b) {
                                         return weights.dot(a.features) < weights.dot(b.features);
                                       });
    right += best->at_truth ? 1.0 : 0.0;
    n += 1.0;
  }
  return n > 0.0 ? right / n : 0.0;
}

}  // namespace place_memory::training
