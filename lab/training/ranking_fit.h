#ifndef PLACE_MEMORY_TRAINING_RANKING_FIT_H
#define PLACE_MEMORY_TRAINING_RANKING_FIT_H

#include <Eigen/Core>
#include <vector>

namespace place_memory::training {

/// A choice among candidates, some of which are right.
struct Choice {
  Eigen::MatrixXd features;  ///< a row per candidate
  std::vector<bool> right;   ///< likewise
  double weight = 1.0;       ///< in a fit
};

/// Weighted mean over the choices of -log of the softmax share of the right candidates [nats].
/// Choices without a right candidate do not count.
double rankingLoss(const std::vector<Choice>& choices, const Eigen::VectorXd& weights);

/// The factor on the weights with the least rankingLoss(), from 2^-12 to 4.
double bestScale(const std::vector<Choice>& choices, const Eigen::VectorXd& weights);

/// Weights that minimise rankingLoss() plus `ridge` times their squared distance from those of
/// `prior` at its best scale, measured in standard deviations of each feature: Newton's method. The
/// last `costs` weights do not rise above 0.
Eigen::VectorXd fitRanking(const std::vector<Choice>& choices, const Eigen::VectorXd& prior,
                           double ridge, Eigen::Index costs);

/// Share of the choices with a right candidate in which such a one scores best.
double topOne(const std::vector<Choice>& choices, const Eigen::VectorXd& weights);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_RANKING_FIT_H
