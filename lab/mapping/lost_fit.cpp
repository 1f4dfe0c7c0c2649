// Fits what scans say of whether a robot is lost.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/lost_estimate.h"
#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"

namespace place_memory::mapping {
namespace {

using core::kCompassTurns;
using core::kContinuities;
using core::kScanWitnesses;
using core::LostModel;
using experiments::fixed;

constexpr std::array<const char*, kScanWitnesses> kNames{"agrees",      "silent", "misses",
                                                         "contradicts", "doubts", "elsewhere"};

constexpr std::array<const char*, kContinuities> kContinuityNames{"are few", "go on", "falter",
                                                                  "break", "surely break"};
constexpr std::array<const char*, kCompassTurns> kCompassNames{"is not seen", "turns as odometry",
                                                               "turns otherwise"};
/// A spot is judged when the robot is half a metre further.
constexpr double kJudgedLater = 0.5;  // [m]

// What is asked, so that a model is the better the less it takes of these together.
constexpr double kMostLate = 0.05;   ///< share of losses that are told late
constexpr double kMostAlarms = 0.5;  ///< false ones by the kilometre: half of what is asked
constexpr double kMostOff = 0.05;    ///< distance of P(lost) from what was true
constexpr double kSharpness = 0.5;   ///< what a log loss of 1 counts beside these
constexpr int kScansToSay = 3;       ///< without a reading from before
constexpr double kSettled = 10.0;    ///< way after a loss in which an alarm is no false one [m]

/// What a scan showed, and whether the robot was lost.
struct Example {
  core::ScanWitness witness;
  core::Spot spot;
  std::optional<bool> carried;  ///< within what that speaks of, where it is not near its ends
  double way;                   ///< since the one before [m]; below 0: the first of a sequence
  std::optional<bool> lost;     ///< where that can be told
  std::size_t loss;             ///< losses so far in all runs
  int clean;                    ///< scans since the newest of them that hold no reading from before
  double since;                 ///< way since that [m]
};

/// Whether it tells of the model: a scan that was begun where the robot was carried from cannot.
bool tells(const Example& example) {
  return example.lost && !(*example.lost && example.loss > 0 && example.clean == 0);
}

/// Whether the robot was carried between two points of the way; nothing where it was next to them.
std::optional<bool> carriedBefore(const std::vector<double>& losses_at, double from, double to) {
  bool near = false;
  for (const double at : losses_at) {
    if (at > from && at <= to) return true;
    near = near || (at > from - kJudgedLater && at <= to + kJudgedLater);
  }
  return near ? std::nullopt : std::make_optional(false);
}

/// Examples of several runs.
class Examples {
 public:
  void add(const MappingRun& run) {
    std::vector<double> losses_at;
    for (const MomentRecord& moment : run.moments) {
      if (moment.carried) losses_at.push_back(moment.way);
    }
    std::size_t loss = 0;
    int clean = 0;
    double last = -1.0;
    bool goes_on = false;
    std::chrono::nanoseconds newest{0};
    for (const DecisionRecord& record : run.decisions) {
      if (record.decision.stamp <= newest) continue;  // a later word on an older scan
      newest = record.decision.stamp;
      while (loss < losses_at.size() && record.last_way >= losses_at[loss]) {
        ++loss;
        clean = 0;
      }
      const double at = loss == 0 ? -INFINITY : losses_at[loss - 1];
      clean += record.first_way >= at ? 1 : 0;
      const bool told = (run.moments[record.moment].online || record.astray) &&
                        record.decision.kind != core::ScanDecision::Kind::kClosed;
      if (told) {
        examples_.push_back(
            {record.decision.witness, record.decision.spot,
             carriedBefore(losses_at, last - kJudgedLater, record.last_way - kJudgedLater),
             goes_on ? record.last_way - last : -1.0, record.astray, losses_ + loss, clean,
             record.last_way - at});
      }
      goes_on = told;
      last = record.last_way;
    }
    losses_ += losses_at.size();
    way_ += run.way();
  }

  const std::vector<Example>& all() const { return examples_; }
  std::size_t losses() const { return losses_; }
  double way() const { return way_; }

 private:
  std::vector<Example> examples_;
  std::size_t losses_ = 0;
  double way_ = 0.0;  ///< [m]
};

/// How a model does on examples.
struct Worth {
  double late = 0.0;    ///< share of losses
  double alarms = 0.0;  ///< by the kilometre
  double off = 0.0;     ///< mean distance of P(lost) from what was true, in ten bins
  double log_loss = 0.0;
  double cost() const {
    return late / kMostLate + alarms / kMostAlarms + off / kMostOff + kSharpness * log_loss;
  }
};

/// `fresh`: an estimate that has seen nothing.
Worth worthOf(const core::LostEstimate& fresh, const Examples& examples) {
  std::array<double, 10> off{};
  std::vector<char> seen(examples.losses() + 1, 0), told(examples.losses() + 1, 0);
  Worth worth;
  double count = 0.0;
  bool alarm = false;
  core::LostEstimate estimate = fresh;
  for (const Example& example : examples.all()) {
    if (example.way < 0.0) estimate = fresh;
    estimate.drive(example.spot, std::max(example.way, 0.0));
    estimate.see(example.witness);
    const double lost = estimate.probability();
    const bool is_alarm = lost > 0.5;
    const bool soon = example.clean <= kScansToSay;
    if (soon && example.lost.value_or(false)) seen[example.loss] = 1;
    if (soon && is_alarm) told[example.loss] = 1;
    worth.alarms +=
        is_alarm && !alarm && !example.lost.value_or(true) && example.since > kSettled ? 1.0 : 0.0;
    alarm = is_alarm;
    if (!tells(example)) continue;
    off[static_cast<std::size_t>(std::min(9.0, 10.0 * lost))] += lost - (*example.lost ? 1.0 : 0.0);
    worth.log_loss -= std::log(*example.lost ? lost : 1.0 - lost);
    count += 1.0;
  }
  double losses = 0.0;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    losses += seen[i] != 0 ? 1.0 : 0.0;
    worth.late += seen[i] != 0 && told[i] == 0 ? 1.0 : 0.0;
  }
  for (const double bin : off) worth.off += std::abs(bin);
  worth.late /= std::max(losses, 1.0);
  worth.alarms *= 1000.0 / std::max(examples.way(), 1.0);
  worth.off /= std::max(count, 1.0);
  worth.log_loss /= std::max(count, 1.0);
  return worth;
}

/// By kind, where it does not hold and where it does.
template <std::size_t kinds>
using Counts = std::array<std::array<double, 2>, kinds>;

template <std::size_t kinds>
std::array<double, kinds> softened(const Counts<kinds>& counts, double softening) {
  std::array<double, 2> all{};
  for (const auto& count : counts) {
    for (const std::size_t holds : {0U, 1U}) all[holds] += count[holds] + 0.5;
  }
  std::array<double, kinds> ratios{};
  for (std::size_t i = 0; i < kinds; ++i) {
    const double ratio = ((counts[i][1] + 0.5) / all[1]) / ((counts[i][0] + 0.5) / all[0]);
    ratios[i] = std::pow(ratio, softening);
  }
  return ratios;
}

/// How often each is seen.
struct AllCounts {
  Counts<kScanWitnesses> witnesses{};
  Counts<kContinuities> readings{};
  Counts<kCompassTurns> compass{};
};

LostModel softened(const AllCounts& counts, double softening) {
  LostModel model{0.001, softened(counts.witnesses, softening),
                  softened(counts.readings, softening), softened(counts.compass, softening)};
  // Where nothing can be seen again nothing is said.
  model.ratios[static_cast<std::size_t>(core::ScanWitness::kSilent)] = 1.0;
  model.readings[static_cast<std::size_t>(core::Continuity::kUnseen)] = 1.0;
  model.compass[static_cast<std::size_t>(core::CompassTurn::kUnseen)] = 1.0;
  return model;
}

/// Betters one number after the other, by ever smaller factors.
LostModel descend(LostModel model, const Examples& examples) {
  double least = worthOf(core::LostEstimate(model), examples).cost();
  const auto tryNumber = [&](double& number, double factor) {
    const double before = number;
    number *= factor;
    const double cost = worthOf(core::LostEstimate(model), examples).cost();
    if (cost < least) {
      least = cost;
      return true;
    }
    number = before;
    return false;
  };
  for (const double factor : {2.0, 1.5, 1.25, 1.1}) {
    for (int round = 0; round < 4; ++round) {
      bool better = false;
      for (const double by : {factor, 1.0 / factor}) {
        better = tryNumber(model.lifted_per_metre, by) || better;
        for (std::size_t i = 0; i < kScanWitnesses; ++i) {
          if (i == static_cast<std::size_t>(core::ScanWitness::kSilent)) continue;
          better = tryNumber(model.ratios[i], by) || better;
        }
      }
      if (!better) break;
    }
  }
  return model;
}

template <std::size_t kinds>
void addRows(experiments::Table& table, const std::array<const char*, kinds>& names,
             const Counts<kinds>& counts, const std::array<double, kinds>& ratios) {
  for (std::size_t i = 0; i < kinds; ++i) {
    table.add({names[i], fixed(counts[i][1], 0), fixed(counts[i][0], 0), fixed(ratios[i], 3)});
  }
}

}  // namespace

experiments::Table lostFit(const SuiteOptions& options) {
  Examples examples;
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      DrivePart part;
      part.compass = options.compass && i % 2 == 0;
      // Most robots are never carried.
      for (const bool carried : {true, false}) {
        core::Mapper mapper(mapperOptions());
        Truth truth;
        const trials::Drive moments =
            carried ? carriedDrive(options, name, seed)
                    : trials::simulateDrive(mappingWorld(name, seed, options.worlds), {},
                                            recipeOf(options), seed);
        examples.add(drive(mapper, moments, part, truth));
      }
    }
  }
  AllCounts counts;
  for (const Example& example : examples.all()) {
    if (example.carried) {
      const std::size_t column = *example.carried ? 1 : 0;
      ++counts.readings[static_cast<std::size_t>(example.spot.readings)][column];
      ++counts.compass[static_cast<std::size_t>(example.spot.compass)][column];
    }
    if (!tells(example)) continue;
    ++counts.witnesses[static_cast<std::size_t>(example.witness)][*example.lost ? 1 : 0];
  }
  LostModel best{};
  double least = INFINITY;
  for (double softening = 0.3; softening <= 1.01; softening += 0.175) {
    const LostModel model = descend(softened(counts, softening), examples);
    const double cost = worthOf(core::LostEstimate(model), examples).cost();
    if (cost >= least) continue;
    least = cost;
    best = model;
  }
  const Worth worth = worthOf(core::LostEstimate(best), examples);
  experiments::Table table({"a scan that", "lost", "not lost", "ratio"});
  addRows(table, kNames, counts.witnesses, best.ratios);
  table.add({"where readings", "carried", "not carried", "ratio"});
  addRows(table, kContinuityNames, counts.readings, best.readings);
  table.add({"where the compass", "carried", "not carried", "ratio"});
  addRows(table, kCompassNames, counts.compass, best.compass);
  table.add({"lifted by the metre", "", "", fixed(best.lifted_per_metre, 4)});
  table.add({"losses", std::to_string(examples.losses()), "", ""});
  const Worth now = worthOf(core::LostEstimate(), examples);
  table.add({"", "", "now", "fitted"});
  table.add({"told late", "", fixed(now.late, 3), fixed(worth.late, 3)});
  table.add({"false alarms by the kilometre", "", fixed(now.alarms, 2), fixed(worth.alarms, 2)});
  table.add({"calibration error", "", fixed(now.off, 4), fixed(worth.off, 4)});
  table.add({"log loss", "", fixed(now.log_loss, 4), fixed(worth.log_loss, 4)});
  return table;
}

}  // namespace place_memory::mapping
