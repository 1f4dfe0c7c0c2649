#include "training/ranking_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace place_memory::training {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostSteps = 50;
constexpr double kLeastGain = 1e-7;  ///< of the loss, for one more step

/// Softmax shares of the candidates, and of the right ones among themselves.
struct Shares {
  VectorXd all;
  VectorXd right;
  double right_share = 0.0;
};

Shares sharesOf(const Choice& choice, const VectorXd& weights) {
  Shares shares;
  shares.all = choice.features * weights;
  shares.all = (shares.all.array() - shares.all.maxCoeff()).exp();
  shares.all /= shares.all.sum();
  shares.right = shares.all;
  for (Index i = 0; i < shares.right.size(); ++i) {
    if (!choice.right[static_cast<std::size_t>(i)]) shares.right[i] = 0.0;
  }
  shares.right_share = shares.right.sum();
  if (shares.right_share > 0.0) shares.right /= shares.right_share;
  return shares;
}

bool hasRight(const Choice& choice) {
  return std::find(choice.right.begin(), choice.right.end(), true) != choice.right.end();
}

/// Standard deviation of each feature over all candidates; 1 where it is 0.
VectorXd spreadOf(const std::vector<Choice>& choices, Index size) {
  VectorXd sum = VectorXd::Zero(size), squares = VectorXd::Zero(size);
  double n = 0.0;
  for (const Choice& choice : choices) {
    sum += choice.features.colwise().sum().transpose();
    squares += choice.features.cwiseAbs2().colwise().sum().transpose();
    n += static_cast<double>(choice.features.rows());
  }
  const VectorXd spread = (squares / n - (sum / n).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return spread.unaryExpr([](double s) { return s > 0.0 ? s : 1.0; });
}

class Objective {
 public:
  Objective(const std::vector<Choice>& choices, const VectorXd& prior, double ridge)
      : choices_(choices),
        prior_(prior),
        curve_(2.0 * ridge * spreadOf(choices, prior.size()).cwiseAbs2()) {}

  double at(const VectorXd& weights) const {
    return rankingLoss(choices_, weights) + 0.5 * (weights - prior_).cwiseAbs2().dot(curve_);
  }

  VectorXd newtonStep(const VectorXd& weights) const {
    VectorXd gradient = VectorXd::Zero(prior_.size());
    MatrixXd hessian = MatrixXd::Zero(prior_.size(), prior_.size());
    double n = 0.0;
    for (const Choice& choice : choices_) {
      if (!hasRight(choice)) continue;
      n += choice.weight;
      const Shares shares = sharesOf(choice, weights);
      const VectorXd mean = choice.features.transpose() * shares.all;
      gradient += choice.weight * (mean - choice.features.transpose() * shares.right);
      hessian +=
          choice.weight * (choice.features.transpose() * shares.all.asDiagonal() * choice.features -
                           mean * mean.transpose());
    }
    gradient = gradient / n + (weights - prior_).cwiseProduct(curve_);
    hessian = hessian / n;
    // The part of the right candidates' spread is left out, so that the matrix stays positive.
    hessian.diagonal() += curve_ + VectorXd::Constant(prior_.size(), 1e-12);
    return hessian.ldlt().solve(gradient);
  }

 private:
  const std::vector<Choice>& choices_;
  VectorXd prior_;
  VectorXd curve_;
};

VectorXd withinBounds(VectorXd weights, Index costs) {
  weights.tail(costs) = weights.tail(costs).cwiseMin(0.0);
  return weights;
}

}  // namespace

double rankingLoss(const std::vector<Choice>& choices, const VectorXd& weights) {
  constexpr double kLeastShare = 1e-12;
  double loss = 0.0, n = 0.0;
  for (const Choice& choice : choices) {
    if (!hasRight(choice)) continue;
    loss -= choice.weight * std::log(std::max(sharesOf(choice, weights).right_share, kLeastShare));
    n += choice.weight;
  }
  return n > 0.0 ? loss / n : 0.0;
}

double bestScale(const std::vector<Choice>& choices, const VectorXd& weights) {
  double best = 1.0, least = INFINITY;
  for (double exponent = -12.0; exponent <= 2.0; exponent += 0.125) {
    const double scale = std::exp2(exponent);
    const double loss = rankingLoss(choices, scale * weights);
    if (loss < least) {
      least = loss;
      best = scale;
    }
  }
  return best;
}

VectorXd fitRanking(const std::vector<Choice>& choices, const VectorXd& prior, double ridge,
                    Index costs) {
  const VectorXd start = withinBounds(prior, costs);
  const VectorXd scaled = bestScale(choices, start) * start;
  const Objective objective(choices, scaled, ridge);
  VectorXd weights = scaled;
  double loss = objective.at(weights);
  for (int i = 0; i < kMostSteps; ++i) {
    const VectorXd step = objective.newtonStep(weights);
    double gain = 0.0;
    for (double share = 1.0; share > 1e-4 && gain <= 0.0; share *= 0.5) {
      const VectorXd next = withinBounds(weights - share * step, costs);
      gain = loss - objective.at(next);
      if (gain > 0.0) weights = next;
    }
    loss -= std::max(gain, 0.0);
    if (gain < kLeastGain) break;
  }
  return weights;
}

double topOne(const std::vector<Choice>& choices, const VectorXd& weights) {
  double right = 0.0, n = 0.0;
  for (const Choice& choice : choices) {
    if (!hasRight(choice)) continue;
    Index best = 0;
    (choice.features * weights).maxCoeff(&best);
    right += choice.right[static_cast<std::size_t>(best)] ? 1.0 : 0.0;
    n += 1.0;
  }
  return n > 0.0 ? right / n : 0.0;
}

}  // namespace place_memory::training
