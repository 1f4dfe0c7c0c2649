#include "experiments/summary_table.h"

#include <algorithm>
#include <array>

#include "experiments/statistics.h"

namespace place_memory::experiments {
namespace {

std::string share(std::size_t part, std::size_t whole) {
  return whole > 0 ? fixed(static_cast<double>(part) / static_cast<double>(whole), 3) : "";
}

std::vector<const Method*> methodsOf(const std::vector<Outcome>& outcomes) {
  std::vector<const Method*> methods;
  for (const Outcome& outcome : outcomes) {
    if (std::count(methods.begin(), methods.end(), outcome.method) == 0) {
      methods.push_back(outcome.method);
    }
  }
  return methods;
}

std::vector<const Experiment*> experimentsOf(const std::vector<Outcome>& outcomes) {
  std::vector<const Experiment*> experiments;
  for (const Outcome& outcome : outcomes) {
    if (std::count(experiments.begin(), experiments.end(), outcome.experiment) == 0) {
      experiments.push_back(outcome.experiment);
    }
  }
  return experiments;
}

const Outcome* find(const std::vector<Outcome>& outcomes, const Experiment* experiment,
                    const Method* method) {
  const auto it = std::find_if(outcomes.begin(), outcomes.end(), [&](const Outcome& outcome) {
    return outcome.experiment == experiment && outcome.method == method;
  });
  return it == outcomes.end() ? nullptr : &*it;
}

std::vector<Answer> answersOf(const std::vector<Outcome>& outcomes, const std::string& method) {
  std::vector<Answer> answers;
  for (const Outcome& outcome : outcomes) {
    if (outcome.method->name != method) continue;
    answers.insert(answers.end(), outcome.answers.begin(), outcome.answers.end());
  }
  return answers;
}

bool inPaper(const std::vector<const Experiment*>& experiments, const Method* method) {
  return std::any_of(experiments.begin(), experiments.end(), [&](const Experiment* experiment) {
    return experiment->paper.count(method->name) > 0;
  });
}

const std::vector<std::string> kVerdictColumns = {
    "trials",    "accuracy",     "mean error [m]", "within 1 ft", "recognized",
    "wrong",     "strangers in", "unlearned in",   "ECE",         "normalised error",
    "its bounds"};

std::vector<std::string> verdictCells(const Summary& summary) {
  std::vector<std::string> cells = {std::to_string(summary.known),
                                    withInterval(summary.right, summary.known, 3),
                                    fixed(summary.position_error, 3),
                                    fixed(summary.within_foot, 3),
                                    share(summary.recognized, summary.known),
                                    share(summary.wrong, summary.known),
                                    withInterval(summary.accepted, summary.strangers, 3),
                                    withInterval(summary.unlearned_accepted, summary.unlearned, 3),
                                    fixed(summary.calibration_error, 3),
                                    fixed(summary.normalised_error, 2)};
  if (summary.posed > 0) {
    const Bounds bounds = consistencyBounds(summary.posed);
    cells.push_back(fixed(bounds.low, 2) + " to " + fixed(bounds.high, 2));
  } else {
    cells.emplace_back();
  }
  return cells;
}

std::vector<std::string> joined(std::vector<std::string> front,
                                const std::vector<std::string>& back) {
  front.insert(front.end(), back.begin(), back.end());
  return front;
}

}  // namespace

Table accuracyTable(const std::vector<Outcome>& outcomes) {
  const auto methods = methodsOf(outcomes);
  const auto experiments = experimentsOf(outcomes);
  std::vector<std::string> header = {"experiment", "case"};
  for (const Method* method : methods) {
    if (inPaper(experiments, method)) header.push_back("paper");
    header.push_back(method->title);
  }
  Table table(header);
  for (const Experiment* experiment : experiments) {
    std::vector<std::string> row = {experiment->group, experiment->name};
    for (const Method* method : methods) {
      if (inPaper(experiments, method)) {
        const auto paper = experiment->paper.find(method->name);
        row.push_back(paper == experiment->paper.end() ? "" : fixed(paper->second, 2));
      }
      const Outcome* outcome = find(outcomes, experiment, method);
      const Summary summary = outcome == nullptr ? Summary{} : summarize(outcome->answers);
      row.push_back(withInterval(summary.right, summary.known, 2));
    }
    table.add(row);
  }
  return table;
}

Table verdictTable(const std::vector<Outcome>& outcomes, const std::string& method) {
  Table table(joined({"experiment", "case"}, kVerdictColumns));
  for (const Outcome& outcome : outcomes) {
    if (outcome.method->name != method) continue;
    table.add(joined({outcome.experiment->group, outcome.experiment->name},
                     verdictCells(summarize(outcome.answers))));
  }
  table.add(joined({"all", ""}, verdictCells(summarize(answersOf(outcomes, method)))));
  return table;
}

Table verdictShareTable(const std::vector<Outcome>& outcomes, const std::string& method) {
  struct Kind {
    const char* name;
    bool known, stranger, right;
  };
  constexpr Kind kKinds[] = {{"learned place, best match right", true, false, true},
                             {"learned place, best match wrong", true, false, false},
                             {"place of the building, never learned", false, false, false},
                             {"place of another building", false, true, false}};
  const std::vector<Answer> answers = answersOf(outcomes, method);
  Table table({"scan of", "scans", "RECOGNIZED", "AMBIGUOUS", "UNKNOWN"});
  for (const Kind& kind : kKinds) {
    std::size_t all = 0;
    std::array<std::size_t, 3> of{};  // by verdict
    for (const Answer& answer : answers) {
      if (answer.known != kind.known || answer.stranger != kind.stranger ||
          answer.right != kind.right) {
        continue;
      }
      ++all;
      ++of[static_cast<std::size_t>(answer.verdict)];
    }
    const auto shareOf = [&](core::Verdict verdict) {
      return share(of[static_cast<std::size_t>(verdict)], all);
    };
    table.add({kind.name, std::to_string(all), shareOf(core::Verdict::kRecognized),
               shareOf(core::Verdict::kAmbiguous), shareOf(core::Verdict::kUnknown)});
  }
  return table;
}

Table methodTable(const std::vector<Outcome>& outcomes) {
  Table table(joined({"method"}, kVerdictColumns));
  for (const Method* method : methodsOf(outcomes)) {
    table.add(joined({method->title}, verdictCells(summarize(answersOf(outcomes, method->name)))));
  }
  return table;
}

Table summaryTable(const std::vector<Outcome>& outcomes) {
  Table table({"experiment",
               "case",
               "x",
               "method",
               "trials",
               "right",
               "accuracy",
               "low",
               "high",
               "paper",
               "position_error",
               "within_foot",
               "recognized",
               "wrong",
               "strangers",
               "accepted",
               "unlearned",
               "unlearned_accepted",
               "calibration_error",
               "posed",
               "normalised_error"});
  for (const Outcome& outcome : outcomes) {
    const Summary summary = summarize(outcome.answers);
    const Bounds bounds = wilsonInterval(summary.right, summary.known);
    const auto paper = outcome.experiment->paper.find(outcome.method->name);
    table.add({outcome.experiment->group,
               outcome.experiment->name,
               fixed(outcome.experiment->x, 6),
               outcome.method->name,
               std::to_string(summary.known),
               std::to_string(summary.right),
               fixed(summary.accuracy(), 4),
               fixed(bounds.low, 4),
               fixed(bounds.high, 4),
               paper == outcome.experiment->paper.end() ? "" : fixed(paper->second, 4),
               fixed(summary.position_error, 4),
               fixed(summary.within_foot, 4),
               std::to_string(summary.recognized),
               std::to_string(summary.wrong),
               std::to_string(summary.strangers),
               std::to_string(summary.accepted),
               std::to_string(summary.unlearned),
               std::to_string(summary.unlearned_accepted),
               fixed(summary.calibration_error, 4),
               std::to_string(summary.posed),
               fixed(summary.normalised_error, 4)});
  }
  return table;
}

Table reliabilityTable(const std::vector<Outcome>& outcomes) {
  Table table({"method", "low", "high", "answers", "right", "mean_probability"});
  for (const Method* method : methodsOf(outcomes)) {
    const Summary summary = summarize(answersOf(outcomes, method->name));
    for (std::size_t i = 0; i < kReliabilityBins; ++i) {
      const ReliabilityBin& bin = summary.reliability[i];
      const auto answers = static_cast<double>(bin.answers);
      table.add({method->name, fixed(static_cast<double>(i) / kReliabilityBins, 1),
                 fixed(static_cast<double>(i + 1) / kReliabilityBins, 1),
                 std::to_string(bin.answers), std::to_string(bin.right),
                 bin.answers > 0 ? fixed(bin.probability_sum / answers, 4) : ""});
    }
  }
  return table;
}

Table calibrationTable(const std::vector<Outcome>& outcomes, const std::string& method) {
  Table table({"probability of the best match", "answers", "its mean", "right"});
  const Summary summary = summarize(answersOf(outcomes, method));
  for (std::size_t i = 0; i < kReliabilityBins; ++i) {
    const ReliabilityBin& bin = summary.reliability[i];
    if (bin.answers == 0) continue;
    const auto answers = static_cast<double>(bin.answers);
    table.add({fixed(static_cast<double>(i) / kReliabilityBins, 1) + " to " +
                   fixed(static_cast<double>(i + 1) / kReliabilityBins, 1),
               std::to_string(bin.answers), fixed(bin.probability_sum / answers, 3),
               withInterval(bin.right, bin.answers, 3)});
  }
  return table;
}

}  // namespace place_memory::experiments
