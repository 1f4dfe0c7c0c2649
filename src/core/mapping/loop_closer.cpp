#include "core/mapping/loop_closer.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;

constexpr double kWitnessNear = 0.7;  ///< a witness aligns so near to where its candidate is [m]
constexpr double kWitnessWindow = 20.0 * kDegree;
constexpr int kIterations = 15;

constexpr double kMostSuffered = 25.0;  ///< chi square by which all older ties may rise
constexpr double kMostOfTie = 25.0;     ///< chi square of one tie that counts
constexpr double kOutvoted = 16.0;      ///< chi square from which a tie is outvoted

constexpr double kTrialWay = 6.0;       // [m]
constexpr double kJoinTrialWay = 12.0;  // [m]
constexpr int kTrialMisses = 4;

double suffered(const ScanGraph& graph, int without) {
  double chi = 0.0;
  for (const Tie& tie : graph.ties()) {
    if (tie.closure != without) chi += std::min(graph.chiSquare(tie), kMostOfTie);
  }
  return chi;
}

}  // namespace

void LoopCloser::tieWitnesses(const ClosureCandidate& candidate, bool joins, int number) {
  for (const Witness& witness : candidate.witnesses) {
    if (!shelf_.has(witness.place)) continue;
    const Pose2d& pose = graph_.node(witness.node).pose;
    const Pose2d there = joins ? pose : candidate.target_from_estimate * pose;
    tying_.tie(witness.place, witness.node, tying_.lay(witness.node, there), kWitnessNear,
               kWitnessWindow, number);
  }
}

bool LoopCloser::holds(int number, double old_chi) {
  int fresh = 0, outvoted = 0;
  for (const Tie& tie : graph_.ties()) {
    if (tie.closure != number) continue;
    ++fresh;
    outvoted += graph_.chiSquare(tie) > kOutvoted ? 1 : 0;
  }
  return fresh > 0 && 3 * outvoted <= fresh && suffered(graph_, number) <= old_chi + kMostSuffered;
}

bool LoopCloser::close(const ClosureCandidate& candidate, int session, int target, bool moves_map,
                       double way) {
  const int number = ++closures_;
  const bool joins = session != target;
  Trial trial{number, way, std::nullopt, 0, candidate.target_from_estimate, 0, 0};
  if (joins) {
    trial.joined = session;
    while (graph_.node(trial.first_joined).session != session) ++trial.first_joined;
    graph_.join(session, target, candidate.target_from_estimate);
    shelf_.join(session, target, graph_);
  }
  if (!moves_map) {
    tieWitnesses(candidate, joins, number);
    trial_ = trial;
    return true;
  }
  const ScanGraph::Lie before = graph_.lie();
  const double old_chi = suffered(graph_, number);
  tieWitnesses(candidate, joins, number);
  // Far off, doubted ties would pull no more: first it is looked where they lead to.
  graph_.relaxAll(target, kIterations, number);
  graph_.relaxAll(target, kIterations);
  if (holds(number, old_chi)) {
    trial_ = trial;
    return true;
  }
  // An older closure that suffers under two new ones was the wrong one.
  std::map<int, double> rise;
  for (const Tie& tie : graph_.ties()) {
    if (tie.closure != 0 && tie.closure != number) rise[tie.closure] += graph_.chiSquare(tie);
  }
  for (const auto& [closure, chi] : rise) {
    if (chi > kMostSuffered && ++contradicted_[closure] >= 2) {
      graph_.untie([number = closure](const Tie& tie) { return tie.closure == number; });
    }
  }
  graph_.setLie(before);
  takeBack(trial);
  return false;
}

void LoopCloser::takeBack(const Trial& trial) {
  graph_.untie([&](const Tie& tie) { return tie.closure == trial.number; });
  if (trial.joined) {
    graph_.split(trial.first_joined, *trial.joined, trial.target_from_session.inverse());
    shelf_.resort(graph_);
  }
  split_ = trial.joined;
}

bool LoopCloser::observe(bool tracked, bool expected, double way) {
  if (!trial_) return false;
  trial_->hits += tracked ? 1 : 0;
  trial_->misses += !tracked && expected ? 1 : 0;
  if (trial_->misses >= kTrialMisses && trial_->misses > trial_->hits) {
    takeBack(*trial_);
    trial_.reset();
    return true;
  }
  if (way - trial_->way > (trial_->joined ? kJoinTrialWay : kTrialWay)) trial_.reset();
  return false;
}

bool LoopCloser::cutTrial(PlaceId place) {
  const auto ties_it = [&](const Tie& tie) {
    return tie.closure == onTrial() && graph_.node(tie.place).place == place;
  };
  if (!trial_ || std::none_of(graph_.ties().begin(), graph_.ties().end(), ties_it)) return false;
  takeBack(*trial_);
  trial_.reset();
  return true;
}

bool LoopCloser::cutContradicted() {
  std::map<int, std::pair<double, int>> ties;
  for (const Tie& tie : graph_.ties()) {
    if (tie.closure == 0) continue;
    auto& [chi, count] = ties[tie.closure];
    chi += std::min(graph_.chiSquare(tie), kMostOfTie);
    ++count;
  }
  // The newest one that no more agrees.
  for (auto closure = ties.rbegin(); closure != ties.rend(); ++closure) {
    if (closure->second.first < 9.0 * closure->second.second) continue;
    graph_.untie([number = closure->first](const Tie& tie) { return tie.closure == number; });
    return true;
  }
  return false;
}

}  // namespace place_memory::core
