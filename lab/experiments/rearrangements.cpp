#include "experiments/rearrangements.h"

#include <algorithm>
#include <string>

#include "config/memory_options.h"
#include "experiments/recipes.h"
#include "experiments/statistics.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::experiments {
namespace {

/// One place in so many is never learned.
constexpr std::size_t kUnlearned = 8;

void forgetSomePlaces(trials::TrialSet& set) {
  std::vector<trials::LearnedScan> learned;
  for (std::size_t i = 0; i < set.learned.size(); ++i) {
    if ((i + 1) % kUnlearned == 0) continue;
    learned.push_back(std::move(set.learned[i]));
  }
  set.learned = std::move(learned);
  const auto is_gone = [&](const std::string& label) {
    return std::none_of(set.learned.begin(), set.learned.end(),
                        [&](const auto& scan) { return scan.label == label; });
  };
  for (trials::RecognitionTrial& trial : set.trials) {
    trial.accept.erase(std::remove_if(trial.accept.begin(), trial.accept.end(), is_gone),
                       trial.accept.end());
  }
}

/// A day of a robot: it learns every place, and then comes back again and again.
class Robot {
 public:
  Robot(const trials::TrialSet& set, const config::Parameters& parameters)
      : sonar_(parameters.sonar),
        geometry_{set.cell_size},
        memory_(memoryOptions(parameters, geometry_)) {
    for (const trials::LearnedScan& place : set.learned) {
      core::Scan scan = scanOf(place.readings);
      scan.odom_from_scan = place.odom_from_scan;
      memory_.learn(scan, place.label);
    }
  }

  Answer visit(const trials::RecognitionTrial& trial) {
    const core::Scan scan = scanOf(trial.readings);
    const core::PlaceMemory::Answer found = memory_.recognize(scan, trial.heading_window);
    Answer answer =
        judge(trial, found.recognition, found.labels.empty() ? "" : found.labels.front());
    answer.folded = found.adapted;
    return answer;
  }

 private:
  static core::PlaceMemoryOptions memoryOptions(const config::Parameters& parameters,
                                                const core::GridGeometry& geometry) {
    core::PlaceMemoryOptions options = config::memoryOptions(parameters);
    options.store_path.clear();
    options.cell_size = geometry.cell_size;
    return options;
  }

  core::Scan scanOf(const std::vector<core::SonarReading>& readings) {
    core::Scan scan;
    scan.readings = readings;
    scan.grid = sonar_.build(readings, geometry_);
    now_ += std::chrono::minutes(1);
    scan.end = now_;
    return scan;
  }

  core::SonarModel sonar_;
  core::GridGeometry geometry_;
  core::PlaceMemory memory_;
  std::chrono::nanoseconds now_{0};
};

std::vector<Answer> runVisits(const Batch& batch, const Method& method) {
  Robot robot(batch.known, method.parameters);
  std::vector<Answer> answers;
  for (const auto& trial : batch.known.trials) answers.push_back(robot.visit(trial));
  return answers;
}

std::vector<Answer> ofRound(const std::vector<Answer>& answers, int round) {
  std::vector<Answer> found;
  std::copy_if(answers.begin(), answers.end(), std::back_inserter(found),
               [&](const Answer& answer) { return answer.round == round; });
  return found;
}

/// By round, and under "all" all of them.
std::vector<std::pair<std::string, std::vector<Answer>>> byRound(
    const std::vector<Answer>& answers) {
  int last = 0;
  for (const Answer& answer : answers) last = std::max(last, answer.round);
  std::vector<std::pair<std::string, std::vector<Answer>>> rounds;
  for (int round = 0; round <= last; ++round) {
    rounds.emplace_back(std::to_string(round + 1), ofRound(answers, round));
  }
  rounds.emplace_back("all", answers);
  return rounds;
}

/// What was folded, and what of it where it does not belong.
struct Folds {
  std::size_t all = 0;
  std::size_t wrong_place = 0;  ///< into another place than the one that was scanned
  std::size_t astray = 0;       ///< more than a foot from where it belongs

  explicit Folds(const std::vector<Answer>& answers) {
    for (const Answer& answer : answers) {
      if (!answer.folded) continue;
      ++all;
      if (!answer.right) ++wrong_place;
      if (answer.distance > kOneFoot) ++astray;
    }
  }
};

}  // namespace

Experiment rearrangementsExperiment(const ShippedWorlds& worlds, int rounds) {
  Experiment experiment;
  experiment.group = "rearrangements";
  experiment.name = "office";
  experiment.make = [&office = worlds.office, rounds](std::uint64_t seed, Sensor sensor) {
    trials::Recipe recipe = rearrangementRecipe();
    if (sensor == Sensor::kLaser) recipe.laser = sim::LaserModel{};
    Batch batch;
    batch.known = trials::simulateRounds(office, sim::SimulatedRobot{}, recipe, rounds, seed);
    forgetSomePlaces(batch.known);
    return batch;
  };
  experiment.run = runVisits;
  return experiment;
}

std::vector<Method> rearrangementMethods(const std::vector<Method>& methods) {
  std::vector<Method> chosen = selectMethods(methods, {"hill_climbing", "default", "default"});
  chosen.back().name = "default_adapting";
  chosen.back().title = "default, places adapt";
  chosen.back().parameters.places.enabled = true;
  return chosen;
}

Table roundAccuracyTable(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> header = {"round"};
  for (const Outcome& outcome : outcomes) header.push_back(outcome.method->title);
  Table table(header);
  std::vector<std::vector<std::string>> rows;
  for (const Outcome& outcome : outcomes) {
    const auto rounds = byRound(outcome.answers);
    rows.resize(rounds.size());
    for (std::size_t i = 0; i < rounds.size(); ++i) {
      if (rows[i].empty()) rows[i].push_back(rounds[i].first);
      const Summary summary = summarize(rounds[i].second);
      rows[i].push_back(withInterval(summary.right, summary.known, 3));
    }
  }
  for (std::vector<std::string>& row : rows) table.add(std::move(row));
  return table;
}

Table foldTable(const std::vector<Outcome>& outcomes) {
  Table table({"round", "scans", "folded", "into another place", "more than 1 ft astray"});
  for (const Outcome& outcome : outcomes) {
    if (!outcome.method->parameters.places.enabled) continue;
    for (const auto& [round, answers] : byRound(outcome.answers)) {
      const Folds folds(answers);
      table.add({round, std::to_string(answers.size()), std::to_string(folds.all),
                 std::to_string(folds.wrong_place), std::to_string(folds.astray)});
    }
  }
  return table;
}

Table roundTable(const std::vector<Outcome>& outcomes) {
  Table table({"method", "round", "trials", "right", "accuracy", "low", "high", "recognized",
               "wrong", "position_error", "unlearned", "unlearned_accepted", "folded",
               "folded_wrong_place", "folded_astray"});
  for (const Outcome& outcome : outcomes) {
    for (const auto& [round, answers] : byRound(outcome.answers)) {
      const Summary summary = summarize(answers);
      const Bounds bounds = wilsonInterval(summary.right, summary.known);
      const Folds folds(answers);
      table.add({outcome.method->name, round, std::to_string(summary.known),
                 std::to_string(summary.right), fixed(summary.accuracy(), 4), fixed(bounds.low, 4),
                 fixed(bounds.high, 4), std::to_string(summary.recognized),
                 std::to_string(summary.wrong), fixed(summary.position_error, 4),
                 std::to_string(summary.unlearned), std::to_string(summary.unlearned_accepted),
                 std::to_string(folds.all), std::to_string(folds.wrong_place),
                 std::to_string(folds.astray)});
    }
  }
  return table;
}

}  // namespace place_memory::experiments
