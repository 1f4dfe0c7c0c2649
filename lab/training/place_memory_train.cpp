#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "place_memory/config/match_preset.h"
#include "place_memory/core/recognizer_options.h"
#include "support/parallel_for.h"
#include "support/progress_bar.h"
#include "training/calibration_fit.h"
#include "training/candidates.h"
#include "training/preset_file.h"
#include "training/ranking_fit.h"
#include "training/sharpness_fit.h"
#include "training/sparse_lists.h"
#include "training/strangers.h"
#include "training/training_worlds.h"
#include "trials/episode_file.h"

namespace {

namespace options = boost::program_options;
using place_memory::config::MatchPreset;
using place_memory::core::MatchMetric;
using place_memory::trials::TrialSet;
using namespace place_memory::training;

/// Alignments found under earlier weights stay in the fit, so that it does not forget them.
constexpr int kRounds = 3;
/// Fitted on simulated worlds of another make; what a fit is pulled towards, so that it does not
/// learn the peculiarities of one simulator.
constexpr place_memory::core::PairWeights kPriorWeights{
    {{0.87, 0.64, -1.38}, {0.05, 0.17, -1.10}, {-2.23, -1.50, 3.52}}};
/// Of each kind of scans with little to go by, beside the buildings' 1.
constexpr double kSparseWeight = 0.04;
/// Of the strangers among those of worlds that look alike wherever one stands: a place wrongly
/// recognized there costs more than one missed.
constexpr double kLookAlikeWeight = 0.4;
/// Pull of the re-scoring towards the search score.
constexpr double kRescoringRidge = 1e-4;

struct Settings {
  std::uint64_t seeds = 240;
  std::uint64_t held_back = 30;
  std::vector<std::string> episodes;
  std::string start;
  double ridge = 0.0;
  std::string origin;
  std::string out;
};

Settings parse(int argc, char** argv) {
  Settings settings;
  options::options_description described(
      "Fits a matching preset on simulated buildings and writes it as YAML. Seeds 0 to N-1 are "
      "fitted on, two thirds of them for the metric and the rest for the calibration, which is "
      "fitted on scans with little to go by as well; the seeds behind them are held back and "
      "reported on.\nOptions");
  described.add_options()("help", "print this");
  described.add_options()("out", options::value(&settings.out)->required(), "YAML file to write");
  described.add_options()("seeds", options::value(&settings.seeds)->default_value(240),
                          "buildings to fit on, at least 3");
  described.add_options()("held-back", options::value(&settings.held_back)->default_value(30),
                          "buildings to report on, at least 2");
  described.add_options()("episodes", options::value(&settings.episodes)->multitoken(),
                          "recorded scans to fit the metric on as well");
  described.add_options()("ridge", options::value(&settings.ridge)->default_value(3e-3),
                          "pull towards the prior weights, >= 0");
  described.add_options()("calibrate", options::value(&settings.start),
                          "keep the metric of this preset, fit its calibration only");
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, described), given);
  if (given.count("help") != 0) {
    std::cout << described;
    std::exit(0);
  }
  options::notify(given);
  if (settings.seeds < 3) throw std::runtime_error("--seeds must be at least 3");
  if (settings.held_back < 2) throw std::runtime_error("--held-back must be at least 2");
  if (!(settings.ridge >= 0.0) || !std::isfinite(settings.ridge)) {
    throw std::runtime_error("--ridge must be at least 0");
  }
  if (!settings.start.empty() && (!settings.episodes.empty() || !given["ridge"].defaulted())) {
    throw std::runtime_error(
        "--calibrate fits no metric: --episodes and --ridge do not go with it");
  }
  std::ostringstream origin;
  origin << "Written by place_memory_train --seeds " << settings.seeds << " --held-back "
         << settings.held_back;
  if (settings.start.empty()) origin << " --ridge " << settings.ridge;
  if (!settings.episodes.empty()) {
    origin << " --episodes " << boost::algorithm::join(settings.episodes, " ");
  }
  if (!settings.start.empty()) origin << " --calibrate " << settings.start;
  settings.origin = origin.str();
  return settings;
}

/// Calls work(i) for every i below count, on all processors; `what` is counted on a bar.
void forEach(std::size_t count, const std::string& what,
             const std::function<void(std::size_t)>& work) {
  place_memory::support::ProgressBar bar(count, what, std::cerr);
  try {
    place_memory::support::parallelFor(count, work, 0,
                                       [&bar](std::size_t done) { bar.show(done); });
  } catch (...) {
    bar.finish();  // what is said of it has a line of its own
    throw;
  }
  bar.finish();
}

std::vector<TrialSet> simulate(std::uint64_t first, std::uint64_t count) {
  std::vector<TrialSet> sets(count);
  forEach(count, "buildings", [&](std::size_t i) { sets[i] = trainingSet(first + i); });
  return sets;
}

using Lists = std::vector<CandidateList>;

std::vector<Lists> align(const std::vector<TrialSet>& sets, const MatchMetric& metric) {
  static const place_memory::core::SonarModel model{{}};
  std::vector<Lists> lists(sets.size());
  forEach(sets.size(), "buildings matched",
          [&](std::size_t i) { lists[i] = alignAll(sets[i], model, metric); });
  return lists;
}

Lists joined(const std::vector<Lists>& parts) {
  Lists all;
  for (const Lists& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The right places as they are aligned now, the wrong ones as they ever were.
void mergeRound(const Lists& round, Lists& merged) {
  if (merged.empty()) {
    merged = round;
    return;
  }
  for (std::size_t i = 0; i < round.size(); ++i) {
    auto& candidates = merged[i].candidates;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [](const Candidate& candidate) { return candidate.at_truth; }),
                     candidates.end());
    candidates.insert(candidates.end(), round[i].candidates.begin(), round[i].candidates.end());
  }
}

/// Fits the metric in rounds, then the re-scoring of what the last metric ranks first.
RankingWeights fitWeights(const std::vector<TrialSet>& sets, double ridge) {
  const Eigen::VectorXd prior = asWeights(MatchMetric{kPriorWeights, 0.0, 0.0});
  RankingWeights weights;
  weights.metric = prior;
  Lists merged;
  for (int round = 1; round <= kRounds; ++round) {
    const Lists lists = joined(align(sets, asMetric(weights.metric)));
    mergeRound(lists, merged);
    weights.metric = fitRanking(searchChoices(merged), prior, ridge, kCosts);
    std::cout << "round " << round << ": " << lists.size() << " scans, loss "
              << rankingLoss(searchChoices(lists), weights.metric) << ", top-1 "
              << topOne(searchChoices(lists), weights.metric) << std::endl;
  }
  const std::vector<Choice> choices =
      rescoringChoices(joined(align(sets, asMetric(weights.metric))), weights.metric);
  const Eigen::VectorXd rescoring =
      fitRanking(choices, asWeights(place_memory::core::RescoringWeights{}), kRescoringRidge, 0);
  std::cout << "re-scoring: loss " << rankingLoss(choices, rescoring) << ", top-1 "
            << topOne(choices, rescoring) << std::endl;
  weights.rescoring = asRescoringWeights(rescoring);
  return weights;
}

/// Scans of places that are not in the memory: places left out, and places of the next building.
Lists strangersTo(const std::vector<TrialSet>& sets, const std::vector<Lists>& aligned,
                  const MatchMetric& metric) {
  const place_memory::core::SonarModel model{{}};
  std::vector<Lists> strangers(2 * sets.size());
  forEach(sets.size(), "memories put to strangers", [&](std::size_t i) {
    strangers[2 * i] = withoutNearPlaces(sets[i], aligned[i], kStrangerDistance);
    for (std::size_t step = 1; step < sets.size(); ++step) {
      const TrialSet& elsewhere = sets[(i + step) % sets.size()];
      if (elsewhere.cell_size != sets[i].cell_size) continue;
      strangers[2 * i + 1] = alignStrangers(sets[i], elsewhere, model, metric);
      break;
    }
  });
  return joined(strangers);
}

using place_memory::trials::SparseKind;

/// Scans of one kind with little to go by, of so many worlds.
CalibrationScans sparseScans(SparseKind kind, std::uint64_t first, std::uint64_t seeds,
                             const MatchMetric& metric) {
  const place_memory::core::SonarModel model{{}};
  std::vector<CalibrationScans> parts(seeds);
  forEach(seeds, std::string("worlds matched: ") + nameOf(kind),
          [&](std::size_t i) { parts[i] = alignSparse(kind, first + i, model, metric); });
  CalibrationScans all;
  for (const CalibrationScans& part : parts) {
    all.known.insert(all.known.end(), part.known.begin(), part.known.end());
    all.strangers.insert(all.strangers.end(), part.strangers.begin(), part.strangers.end());
  }
  all.known_weight = kSparseWeight;
  const bool look_alike = kind == SparseKind::kOpenSpace || kind == SparseKind::kHall;
  all.strangers_weight = look_alike ? kLookAlikeWeight : kSparseWeight;
  return all;
}

void printVerdicts(const CalibrationReport& report, double confidence) {
  std::cout << "answers: top-1 " << report.top_one << "; with confidence " << confidence
            << ": recognized and right " << report.recognized << ", recognized and wrong "
            << report.wrong << ", strangers accepted " << report.accepted
            << "; unknown: known scans " << report.missed << ", strangers " << report.refused
            << "; expected calibration error " << report.calibration_error << '\n';
}

int train(const Settings& settings) {
  MatchPreset preset;
  const std::uint64_t for_metric = settings.seeds * 2 / 3;
  if (!settings.start.empty()) {
    preset = place_memory::config::loadPreset(settings.start);
  } else {
    std::vector<TrialSet> sets = simulate(0, for_metric);
    for (const std::string& path : settings.episodes) {
      sets.push_back(place_memory::trials::readEpisodeFile(path));
    }
    const RankingWeights fitted = fitWeights(sets, settings.ridge);
    preset.metric = asMetric(fitted.metric);
    preset.rescoring = fitted.rescoring;
  }
  const RankingWeights weights{asWeights(preset.metric), preset.rescoring};

  const std::vector<TrialSet> sets = simulate(for_metric, settings.seeds - for_metric);
  const std::vector<Lists> aligned = align(sets, preset.metric);
  const Lists known = joined(aligned);
  const Lists strangers = strangersTo(sets, aligned, preset.metric);
  std::vector<CalibrationScans> parts{
      {joined({known, amongFewPlaces(known)}), joined({strangers, amongFewPlaces(strangers)})}};
  for (const SparseKind kind : place_memory::trials::kEverySparseKind) {
    parts.push_back(sparseScans(kind, for_metric, (sets.size() + 1) / 2, preset.metric));
  }
  preset.calibration = fitCalibration(parts, weights);
  preset.calibration.sharpness =
      fitSharpness(sets, place_memory::core::SonarModel{{}}, preset.metric);
  writePreset(settings.out, settings.origin, preset);

  const std::vector<TrialSet> others = simulate(settings.seeds, settings.held_back);
  const std::vector<Lists> held_back = align(others, preset.metric);
  const double confidence = place_memory::core::RecognizerOptions{}.confidence;
  const CalibrationReport report =
      reportCalibration(joined(held_back), strangersTo(others, held_back, preset.metric), weights,
                        preset.calibration, confidence);
  const std::vector<Choice> choices = searchChoices(joined(held_back));
  std::cout << "held back: search: loss " << rankingLoss(choices, weights.metric) << ", top-1 "
            << topOne(choices, weights.metric) << "; ";
  printVerdicts(report, confidence);
  for (const SparseKind kind : place_memory::trials::kEverySparseKind) {
    const CalibrationScans sparse =
        sparseScans(kind, settings.seeds, (settings.held_back + 1) / 2, preset.metric);
    std::cout << "held back, " << nameOf(kind) << ": ";
    printVerdicts(
        reportCalibration(sparse.known, sparse.strangers, weights, preset.calibration, confidence),
        confidence);
  }
  std::cout << "wrote " << settings.out << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return train(parse(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "place_memory_train: " << error.what() << '\n';
    return 1;
  }
}
