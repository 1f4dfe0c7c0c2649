#include "training/candidates.h"

#include <algorithm>
#include <cmath>

#include "core/match/alignment_search.h"
#include "core/match/lattice.h"
#include "core/recognize/falloff.h"

namespace place_memory::training {
namespace {

Features featuresAt(const core::QueryPlanes& query, const core::CellPlanes& learned,
                    const core::Alignment& at, const core::SearchWindow& window, double cell_size,
                    bool overlap_only) {
  const core::CellPlanes& turned = query.at(at.turn);
  const core::PairCounts counts =
      overlap_only ? core::countOverlap(turned, query.reach(at.turn), at.shift, learned)
                   : core::countPairs(turned, at.shift, learned);
  Features features;
  Eigen::Index i = 0;
  for (const auto& row : counts) {
    for (const int count : row) features[i++] = count;
  }
  const int cells = at.shift.columns * at.shift.columns + at.shift.rows * at.shift.rows;
  features[i++] = cells * cell_size * cell_size;
  const double turn = window.turns > 0 ? static_cast<double>(at.turn) / window.turns : 0.0;
  features[i] = window.circular ? 0.0 : turn * turn;
  return features;
}

constexpr Eigen::Index kLookFeatures = 1 + 9 + 9 + static_cast<Eigen::Index>(core::kNearCells) + 2;

/// An alignment this near to the truth is right [cells, heading steps].
constexpr double kAtTruth = 3.5;

class Memory {
 public:
  Memory(const trials::TrialSet& set, const core::SonarModel& model,
         const core::MatchMetric& metric)
      : set_(set), model_(model), metric_(metric) {
    for (const trials::LearnedScan& scan : set.learned) {
      places_.emplace_back(model.build(scan.readings, {set.cell_size}));
    }
  }

  CandidateList align(const trials::RecognitionTrial& trial) const {
    const core::EvidenceGrid grid = model_.build(trial.readings, {set_.cell_size});
    const core::RecognizerOptions options;
    const core::SearchWindow window =
        core::searchWindow(options.position_window, trial.heading_window, set_.cell_size);
    const core::QueryPlanes query(grid, core::kHeadingStep, window.turns);
    const core::LatticeMetric metric = core::onLattice(metric_, window, set_.cell_size);
    CandidateList list;
    list.cell_size = set_.cell_size;
    list.weight = 1.0 / std::sqrt(static_cast<double>(set_.trials.size()));
    list.own =
        featuresAt(query, core::CellPlanes(grid), {}, window, set_.cell_size, metric_.overlap_only);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const core::Alignment found =
          core::findAlignment(query, places_[i], metric, window, core::SearchMethod::kRestarts);
      const auto& accept = trial.accept;
      const bool right =
          std::find(accept.begin(), accept.end(), set_.learned[i].label) != accept.end();
      const core::Pose2d place_from_scan{found.shift.columns * set_.cell_size,
                                         found.shift.rows * set_.cell_size,
                                         core::wrapAngle(found.turn * core::kHeadingStep)};
      const core::Pose2d odom_from_scan = set_.learned[i].odom_from_scan * place_from_scan;
      const bool at_truth =
          right || (!accept.empty() && near(odom_from_scan, trial.odom_from_scan));
      list.candidates.push_back(
          {i, right, at_truth, place_from_scan, odom_from_scan,
           featuresAt(query, places_[i], found, window, set_.cell_size, metric_.overlap_only),
           core::countClosely(query.at(found.turn), found.shift, places_[i]),
           core::falloffAt(query, places_[i], metric, window, found)});
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
  const core::MatchMetric& metric_;
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
  weights[i] = -metric.turn_cost;
  return weights;
}

core::MatchMetric asMetric(const Features& weights) {
  core::MatchMetric metric;
  Eigen::Index i = 0;
  for (auto& row : metric.weights) {
    for (double& weight : row) weight = weights[i++];
  }
  metric.shift_cost = std::max(-weights[i], 0.0);
  metric.turn_cost = std::max(-weights[i + 1], 0.0);
  return metric;
}

Eigen::VectorXd asWeights(const core::SecondLook& look) {
  Eigen::VectorXd weights(kLookFeatures);
  Eigen::Index i = 0;
  weights[i++] = look.first;
  for (const auto* ring : {&look.inner, &look.middle}) {
    for (const auto& row : *ring) {
      for (const double weight : row) weights[i++] = weight;
    }
  }
  for (const double weight : look.near) weights[i++] = weight;
  weights[i++] = look.beside;
  weights[i] = look.turned;
  return weights;
}

core::SecondLook asSecondLook(const Eigen::VectorXd& weights) {
  core::SecondLook look;
  Eigen::Index i = 0;
  look.first = std::max(weights[i++], 0.0);
  for (auto* ring : {&look.inner, &look.middle}) {
    for (auto& row : *ring) {
      for (double& weight : row) weight = weights[i++];
    }
  }
  for (double& weight : look.near) weight = weights[i++];
  look.beside = weights[i++];
  look.turned = weights[i];
  return look;
}

std::vector<const Candidate*> ranked(const CandidateList& list, const Features& weights) {
  std::vector<const Candidate*> order;
  for (const Candidate& candidate : list.candidates) order.push_back(&candidate);
  std::stable_sort(order.begin(), order.end(), [&](const Candidate* a, const Candidate* b) {
    return weights.dot(a->features) > weights.dot(b->features);
  });
  return order;
}

std::vector<Choice> firstChoices(const std::vector<CandidateList>& lists) {
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

std::vector<Choice> secondChoices(const std::vector<CandidateList>& lists,
                                  const Features& weights) {
  std::vector<Choice> choices;
  for (const CandidateList& list : lists) {
    std::vector<const Candidate*> order = ranked(list, weights);
    order.resize(std::min(order.size(), core::kLookedAtAgain));
    Choice choice{Eigen::MatrixXd(order.size(), kLookFeatures), {}, list.weight};
    for (const Candidate* candidate : order) {
      const auto row = static_cast<Eigen::Index>(choice.right.size());
      Eigen::Index i = 0;
      choice.features(row, i++) = weights.dot(candidate->features);
      for (const auto* ring : {&candidate->closely.inner, &candidate->closely.middle}) {
        for (const auto& counts : *ring) {
          for (const int count : counts) choice.features(row, i++) = count;
        }
      }
      for (const int count : candidate->closely.near) choice.features(row, i++) = count;
      choice.features(row, i++) = candidate->falloff.beside;
      choice.features(row, i) = candidate->falloff.turned;
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
