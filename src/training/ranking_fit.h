#ifndef PLACE_MEMORY_TRAINING_RANKING_FIT_H
#define PLACE_MEMORY_TRAINING_RANKING_FIT_H

#include <vector>

#include "training/candidates.h"

namespace place_memory::training {

/// Weighted mean over the trials of -log of the softmax share of the places that put the
/// robot where it stood, by the weights [nats].
/// Trials without such a place do not count.
double rankingLoss(const std::vector<CandidateList>& lists, const Features& weights);

/// The factor on the weights with the least rankingLoss(), from 2^-6 to 4.
double bestScale(const std::vector<CandidateList>& lists, const Features& weights);

/// Weights that minimise rankingLoss() plus `ridge` times their squared distance from those of
/// `prior` at its best scale, measured in standard deviations of each feature: Newton's method.
/// Costs of the transform stay costs.
Features fitRanking(const std::vector<CandidateList>& lists, const Features& prior, double ridge);

/// Share of the trials with a place that puts the robot where it stood in which such a place
/// scores best.
double topOne(const std::vector<CandidateList>& lists, const Features& weights);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_RANKING_FIT_H
