// Fits what scans say of whether a robot is lost.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/mapping/lost_estimate.h"
#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"

namespace place_memory::mapping {
namespace {

using core::kScanWitnesses;
using core::LostModel;
using experiments::fixed;

constexpr std::array<const char*, kScanWitnesses> kNames{"agrees",      "silent", "misses",
                                                         "contradicts", "doubts", "elsewhere"};

/// What a scan showed, and whether the robot was lost.
struct Example {
  core::ScanWitness witness;
  double way;  ///< since the one before [m]; below 0: the first of a sequence
  bool lost;
};

using Counts = std::array<std::array<double, 2>, kScanWitnesses>;  ///< by witness, not lost or lost

void addExamples(const MappingRun& run, std::vector<Example>& examples) {
  double last = -1.0;
  bool known = false;
  for (const DecisionRecord& record : run.decisions) {
    const bool told = record.astray && run.moments[record.moment].online;
    if (told) {
      examples.push_back(
          {record.decision.witness, known ? record.last_way - last : -1.0, *record.astray});
    }
    known = told;
    last = record.last_way;
  }
}

double logLoss(const LostModel& model, const std::vector<Example>& examples) {
  double loss = 0.0;
  core::LostEstimate estimate(model);
  for (const Example& example : examples) {
    if (example.way < 0.0) estimate = core::LostEstimate(model);
    estimate.update(example.witness, std::max(example.way, 0.0));
    loss -= std::log(example.lost ? estimate.probability() : 1.0 - estimate.probability());
  }
  return loss / std::max<double>(1.0, static_cast<double>(examples.size()));
}

LostModel softened(const Counts& counts, double softening, double lifted) {
  LostModel model{lifted, {}};
  std::array<double, 2> all{};
  for (const auto& count : counts) {
    for (const std::size_t lost : {0U, 1U}) all[lost] += count[lost] + 0.5;
  }
  for (std::size_t i = 0; i < kScanWitnesses; ++i) {
    const double ratio = ((counts[i][1] + 0.5) / all[1]) / ((counts[i][0] + 0.5) / all[0]);
    model.ratios[i] = std::pow(ratio, softening);
  }
  return model;
}

}  // namespace

experiments::Table lostFit(const SuiteOptions& options) {
  std::vector<Example> examples;
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      core::Mapper mapper(mapperOptions());
      Truth truth;
      DrivePart part;
      part.compass = options.compass && i % 2 == 0;
      addExamples(drive(mapper, carriedDrive(options, name, seed), part, truth), examples);
    }
  }
  Counts counts{};
  for (const Example& example : examples) {
    ++counts[static_cast<std::size_t>(example.witness)][example.lost ? 1 : 0];
  }
  LostModel best{0.001, {}};
  double least = INFINITY, softening = 0.0;
  for (double soft = 0.2; soft <= 1.01; soft += 0.1) {
    for (const double lifted : {0.0005, 0.001, 0.002, 0.004}) {
      const LostModel model = softened(counts, soft, lifted);
      const double loss = logLoss(model, examples);
      if (loss >= least) continue;
      least = loss;
      best = model;
      softening = soft;
    }
  }
  experiments::Table table({"a scan that", "lost", "not lost", "ratio"});
  for (std::size_t i = 0; i < kScanWitnesses; ++i) {
    table.add(
        {kNames[i], fixed(counts[i][1], 0), fixed(counts[i][0], 0), fixed(best.ratios[i], 3)});
  }
  table.add({"lifted by the metre", "", "", fixed(best.lifted_per_metre, 4)});
  table.add({"softening", "", "", fixed(softening, 1)});
  table.add({"log loss", "", "", fixed(least, 4)});
  return table;
}

}  // namespace place_memory::mapping
