#ifndef PLACE_MEMORY_TRAINING_CANDIDATES_H
#define PLACE_MEMORY_TRAINING_CANDIDATES_H

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/recognize/rescoring.h"
#include "place_memory/core/match_metric.h"
#include "place_memory/core/sonar_model.h"
#include "training/ranking_fit.h"
#include "trials/trial_set.h"

namespace place_memory::training {

/// What a MatchMetric is linear in: nine counts of pairs, the square of the shift [m^2], and the
/// square of the rotation as a share of the heading window (0 for any heading).
constexpr int kFeatures = 11;
using Features = Eigen::Matrix<double, kFeatures, 1>;

/// A place at the alignment that a search found for it.
struct Candidate {
  std::size_t place = 0;         ///< index in TrialSet::learned
  bool right = false;            ///< its label is right
  bool at_truth = false;         ///< right, or the alignment puts the robot where it stood
  core::Pose2d place_from_scan;  ///< the alignment
  core::Pose2d map_from_place;   ///< where the place lies
  Features features = Features::Zero();
  core::RescoringCounts near;
  core::PeakSharpness sharpness;
};

/// All places against one scan.
struct CandidateList {
  double cell_size = 0.0;  ///< [m]
  /// Of this scan in a fit: less in a building of many, whose scans have much in common.
  double weight = 1.0;
  std::vector<Candidate> candidates;
  Features own = Features::Zero();  ///< the scan against itself
};

/// The metric as weights of the features, and back.
Features asWeights(const core::MatchMetric& metric);
core::MatchMetric asMetric(const Features& weights);
constexpr Eigen::Index kCosts = 2;  ///< of the features, at their end: weights are at most 0

/// What re-scoring is linear in: the search's score, nine pairs of either ring, the near pairs, and
/// the peak's sharpness.
Eigen::VectorXd asWeights(const core::RescoringWeights& rescoring);
core::RescoringWeights asRescoringWeights(const Eigen::VectorXd& weights);

/// Every list as a choice among all its candidates.
std::vector<Choice> searchChoices(const std::vector<CandidateList>& lists);
/// Every list as a choice among those that are re-scored.
std::vector<Choice> rescoringChoices(const std::vector<CandidateList>& lists,
                                     const Features& weights);

/// Candidates by falling search score. Equal ones keep their order.
std::vector<const Candidate*> ranked(const CandidateList& list, const Features& weights);

/// Aligns every scan of the set with every place, by hill climbing with restarts.
std::vector<CandidateList> alignAll(const trials::TrialSet& set, const core::SonarModel& model,
                                    const core::MatchMetric& metric);

/// Aligns the scans of one set with the places of another: nothing is right.
std::vector<CandidateList> alignStrangers(const trials::TrialSet& memory,
                                          const trials::TrialSet& elsewhere,
                                          const core::SonarModel& model,
                                          const core::MatchMetric& metric);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_CANDIDATES_H
