#include "training/candidates.h"

#include <algorithm>
#include <cmath>

#include "core/recognize/scan_query.h"
#include "place_memory/core/recognizer_options.h"

namespace place_memory::training {
namespace {

Features featuresAt(const core::ScanQuery& query, const core::CellPlanes& learned,
                    const core::Alignment& at) {
  const core::CellPlanes& rotated = query.planes().at(at.rotation);
  const core::PairCounts counts =
      query.metric().overlap_only
          ? core::countOverlap(rotated, query.planes().reach(at.rotation), at.shift, learned)
          : core::countPairs(rotated, at.shift, learned);
  Features features;
  Eigen::Index i = 0;
  for (const auto& row : counts) {
    for (const int count : row) features[i++] = count;
  }
  const core::SearchWindow& window = query.window();
  const int cells = at.shift.columns * at.shift.columns + at.shift.rows * at.shift.rows;
  features[i++] = cells * query.cellSize() * query.cellSize();
  const double rotation =
      window.rotations > 0 ? static_cast<double>(at.rotation) / window.rotations : 0.0;
  features[i] = window.circular ? 0.0 : rotation * rotation;
  return features;
}

constexpr Eigen::Index kRescoringFeatures =
    1 + 9 + 9 + static_cast<Eigen::Index>(core::kNearPairs) + 2;

/// An alignment this near to the truth is right [cells, heading steps].
constexpr double kAtTruth = 3.5;

class Memory {
 public:
  Memory(const trials::TrialSet& set, const core::SonarModel& model,
         const core::MatchMetric& metric)
      : set_(set), model_(model) {
    options_.metric = metric;
    for (const trials::LearnedScan& scan : set.learned) {
      places_.emplace_back(model.build(scan.readings, {set.cell_size}));
    }
  }

  CandidateList align(const trials::RecognitionTrial& trial) const {
    const core::EvidenceGrid grid = model_.build(trial.readings, {set_.cell_size});
    const core::ScanQuery query(grid, options_, trial.heading_window);
    CandidateList list;
    list.cell_size = set_.cell_size;
    list.weight = 1.0 / std::sqrt(static_cast<double>(set_.trials.size()));
    list.own = featuresAt(query, core::CellPlanes(grid), {});
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const core::Alignment found = query.align(places_[i]);
      const core::AlignmentCounts counts = query.countsAt(found, places_[i]);
      const auto& accept = trial.accept;
      const bool right =
          std::find(accept.begin(), accept.end(), set_.learned[i].label) != accept.end();
      const core::Pose2d place_from_scan = query.poseOf(found);
      const core::Pose2d& map_from_place = set_.learned[i].odom_from_scan;
      const bool at_truth = right || (!accept.empty() &&
                                      near(map_from_place * place_from_scan, trial.odom_from_scan));
      list.candidates.push_back({i, right, at_truth, place_from_scan, map_from_place,
                                 featuresAt(query, places_[i], found), counts.near,
                                 counts.sharpness});
    }
    return list;
  }

 private:
  bool near(const core::Pose2d& a, const core::Pose2d& b) const {
    return std::hypot(a.x - b.x, a.y - b.y) <= kAtTruth * set_.cell_size &&
           std::abs(core::wrapAngle(a.yaw - b.yaw)) <= kAtTruth * core::kHeadingStep;
  }

  const trials::TrialSet& set_;
  const core::SonarModel& model_;
  core::RecognizerOptions options_;
  std::vector<core::CellPlanes> places_;
};

}  // namespace

Features asWeights(const core::MatchMetric& metric) {
  Features weights;
  Eigen::Index i = 0;
  for (const auto& row : metric.weights) {
    for (const double weight : row) weights[i++] = weight;
  }
  weights[i++] = -metric.shift_cost;
  weights[i] = -metric.rotation_cost;
  return weights;
}

core::MatchMetric asMetric(const Features& weights) {
  core::MatchMetric metric;
  Eigen::Index i = 0;
  for (auto& row : metric.weights) {
    for (double& weight : row) weight = weights[i++];
  }
  metric.shift_cost = std::max(-weights[i], 0.0);
  metric.rotation_cost = std::max(-weights[i + 1], 0.0);
  return metric;
}

Eigen::VectorXd asWeights(const core::RescoringWeights& rescoring) {
  Eigen::VectorXd weights(kRescoringFeatures);
  Eigen::Index i = 0;
  weights[i++] = rescoring.search_score;
  for (const auto* ring : {&rescoring.inner, &rescoring.middle}) {
    for (const auto& row : *ring) {
      for (const double weight : row) weights[i++] = weight;
    }
  }
  for (const double weight : rescoring.near) weights[i++] = weight;
  weights[i++] = rescoring.peak_sharpness_shift;
  weights[i] = rescoring.peak_sharpness_rotation;
  return weights;
}

core::RescoringWeights asRescoringWeights(const Eigen::VectorXd& weights) {
  core::RescoringWeights rescoring;
  Eigen::Index i = 0;
  rescoring.search_score = std::max(weights[i++], 0.0);
  for (auto* ring : {&rescoring.inner, &rescoring.middle}) {
    for (auto& row : *ring) {
      for (double& weight : row) weight = weights[i++];
    }
  }
  for (double& weight : rescoring.near) weight = weights[i++];
  rescoring.peak_sharpness_shift = weights[i++];
  rescoring.peak_sharpness_rotation = weights[i];
  return rescoring;
}

std::vector<const Candidate*> ranked(const CandidateList& list, const Features& weights) {
  std::vector<const Candidate*> order;
  for (const Candidate& candidate : list.candidates) order.push_back(&candidate);
  std::stable_sort(order.begin(), order.end(), [&](const Candidate* a, const Candidate* b) {
    return weights.dot(a->features) > weights.dot(b->features);
  });
  return order;
}

std::vector<Choice> searchChoices(const std::vector<CandidateList>& lists) {
  std::vector<Choice> choices;
  for (const CandidateList& list : lists) {
    Choice choice{Eigen::MatrixXd(list.candidates.size(), kFeatures), {}, list.weight};
    for (const Candidate& candidate : list.candidates) {
      choice.features.row(static_cast<Eigen::Index>(choice.right.size())) = candidate.features;
      choice.right.push_back(candidate.at_truth);
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<Choice> rescoringChoices(const std::vector<CandidateList>& lists,
                                     const Features& weights) {
  std::vector<Choice> choices;
  for (const CandidateList& list : lists) {
    std::vector<const Candidate*> order = ranked(list, weights);
    order.resize(std::min(order.size(), core::kRescored));
    Choice choice{Eigen::MatrixXd(order.size(), kRescoringFeatures), {}, list.weight};
    for (const Candidate* candidate : order) {
      const auto row = static_cast<Eigen::Index>(choice.right.size());
      Eigen::Index i = 0;
      choice.features(row, i++) = weights.dot(candidate->features);
      for (const auto* ring : {&candidate->near.inner, &candidate->near.middle}) {
        for (const auto& counts : *ring) {
          for (const int count : counts) choice.features(row, i++) = count;
        }
      }
      for (const int count : candidate->near.near) choice.features(row, i++) = count;
      choice.features(row, i++) = candidate->sharpness.shift;
      choice.features(row, i) = candidate->sharpness.rotation;
      choice.right.push_back(candidate->at_truth);
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<CandidateList> alignAll(const trials::TrialSet& set, const core::SonarModel& model,
                                    const core::MatchMetric& metric) {
  const Memory memory(set, model, metric);
  std::vector<CandidateList> lists;
  for (const trials::RecognitionTrial& trial : set.trials) lists.push_back(memory.align(trial));
  return lists;
}

std::vector<CandidateList> alignStrangers(const trials::TrialSet& memory,
                                          const trials::TrialSet& elsewhere,
                                          const core::SonarModel& model,
                                          const core::MatchMetric& metric) {
  const Memory places(memory, model, metric);
  std::vector<CandidateList> lists;
  for (trials::RecognitionTrial trial : elsewhere.trials) {
    trial.accept.clear();
    lists.push_back(places.align(trial));
  }
  return lists;
}

}  // namespace place_memory::training
