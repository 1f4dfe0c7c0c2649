#include "mapping/mapping_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapping/final_way.h"

namespace place_memory::mapping {
namespace {

using core::Pose2d;

constexpr double kOld = 20.0;    // [s]
constexpr double kWrong = 0.75;  // [m]
constexpr double kWrongTurn = 20.0 * core::kPi / 180.0;
constexpr double kBack = 0.76;     // so near to a place the robot is back at it [m]
constexpr double kDoubled = 0.6;   // [m]
constexpr int kScansToSay = 3;     // after which a loss should be told
constexpr double kLost = 0.5;      // P(lost) from which it is told
constexpr double kSettled = 10.0;  // way after a loss in which one more alarm is no false one [m]

double seconds(std::chrono::nanoseconds span) {
  return std::chrono::duration<double>(span).count();
}

double distance(const Pose2d& a, const Pose2d& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool wrong(const Pose2d& said, const Pose2d& is) {
  return distance(said, is) > kWrong || std::abs(core::wrapAngle(said.yaw - is.yaw)) > kWrongTurn;
}

using Pairs = std::vector<std::pair<Pose2d, Pose2d>>;

/// Root mean square of what is left between pairs of points after the best rotation and shift, and
/// where `scaled` the best scale.
double leftOver(const Pairs& pairs, bool scaled) {
  if (pairs.empty()) return 0.0;
  const auto count = static_cast<double>(pairs.size());
  Pose2d a, b;
  for (const auto& [p, q] : pairs) {
    a = {a.x + p.x / count, a.y + p.y / count, 0.0};
    b = {b.x + q.x / count, b.y + q.y / count, 0.0};
  }
  double dot = 0.0, cross = 0.0, square = 0.0;
  for (const auto& [p, q] : pairs) {
    dot += (p.x - a.x) * (q.x - b.x) + (p.y - a.y) * (q.y - b.y);
    cross += (p.x - a.x) * (q.y - b.y) - (p.y - a.y) * (q.x - b.x);
    square += (p.x - a.x) * (p.x - a.x) + (p.y - a.y) * (p.y - a.y);
  }
  const double yaw = std::atan2(cross, dot);
  const double scale = scaled ? std::hypot(dot, cross) / std::max(square, 1e-12) : 1.0;
  double sum = 0.0;
  for (const auto& [p, q] : pairs) {
    const Pose2d turned =
        Pose2d{0.0, 0.0, yaw} * Pose2d{scale * (p.x - a.x), scale * (p.y - a.y), 0.0};
    sum += std::pow(turned.x + b.x - q.x, 2) + std::pow(turned.y + b.y - q.y, 2);
  }
  return std::sqrt(sum / count);
}

/// The newest word on each scan.
std::vector<core::ScanDecision> lastWords(const MappingRun& run) {
  std::map<std::chrono::nanoseconds, core::ScanDecision> last;
  for (const DecisionRecord& record : run.decisions) last[record.decision.stamp] = record.decision;
  std::vector<core::ScanDecision> words;
  for (const auto& [stamp, decision] : last) words.push_back(decision);
  return words;
}

void judgeAnswers(const core::Mapper& mapper, const MappingRun& run, const Truth& truth,
                  MappingFigures& found) {
  std::map<core::PlaceId, std::chrono::nanoseconds> born;
  for (const core::MappedPlace& place : mapper.places()) {
    if (!place.apart) born[place.id] = place.stamp;
  }
  for (const core::ScanDecision& decision : lastWords(run)) {
    const std::optional<Pose2d> here = truth.at(decision.stamp);
    if (!here) continue;
    const auto isOld = [&](std::chrono::nanoseconds stamp) {
      return seconds(decision.stamp - stamp) > kOld;
    };
    const bool back = std::any_of(born.begin(), born.end(), [&](const auto& place) {
      return isOld(place.second) && distance(*truth.at(place.second), *here) < kBack;
    });
    const auto named = born.find(decision.place);
    const bool localized = named != born.end() && isOld(named->second);
    found.again += back ? 1 : 0;
    found.known += back && localized ? 1 : 0;
    if (!localized) continue;
    const Pose2d is = truth.at(named->second)->inverse() * *here;
    found.errors.push_back(distance(is, decision.place_from_base));
    found.wrong += wrong(decision.place_from_base, is) ? 1 : 0;
  }
  std::sort(found.errors.begin(), found.errors.end());
  found.answers = found.errors.size();
}

void judgeMap(const core::Mapper& mapper, const Truth& truth, MappingFigures& found) {
  std::vector<Pose2d> made;
  for (const core::MappedPlace& place : mapper.places()) {
    if (!place.apart) made.push_back(*truth.at(place.stamp));
  }
  found.places = made.size();
  for (std::size_t i = 0; i < made.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) found.doubled += distance(made[i], made[j]) < kDoubled;
  }
  for (const core::Tie& tie : mapper.graph().ties()) {
    const std::optional<Pose2d> place = truth.at(mapper.graph().node(tie.place).stamp);
    const std::optional<Pose2d> node = truth.at(mapper.graph().node(tie.node).stamp);
    if (place && node && wrong(tie.relative, place->inverse() * *node)) ++found.false_ties;
  }
}

}  // namespace

MappingFigures figures(const core::Mapper& mapper, const MappingRun& run, const Truth& truth) {
  MappingFigures found;
  found.way = run.way();
  found.cpu = run.way() > 0.0 ? 1000.0 * run.cpu / run.way() : 0.0;
  Pairs online, final;
  const core::FinalWay at_end(mapper.way());
  for (const MomentRecord& moment : run.moments) {
    if (moment.online) online.emplace_back(*moment.online, moment.truth);
    if (!at_end.empty()) final.emplace_back(at_end.at(moment.stamp, moment.odom), moment.truth);
  }
  found.online = leftOver(online, false);
  found.final = leftOver(final, false);
  found.final_scale_free = leftOver(final, true);
  judgeMap(mapper, truth, found);
  judgeAnswers(mapper, run, truth, found);
  return found;
}

void LostFigures::add(const MappingRun& run) {
  way += run.way();
  std::vector<double> losses_at;
  for (const MomentRecord& moment : run.moments) {
    if (moment.carried) losses_at.push_back(moment.way);
  }
  losses += losses_at.size();
  for (const double at : losses_at) {
    int clean = 0;
    for (const DecisionRecord& record : run.decisions) {
      if (record.last_way < at || clean >= kScansToSay) continue;
      clean += record.first_way >= at ? 1 : 0;
      if (record.decision.lost <= kLost) continue;
      ++said;
      break;
    }
  }
  bool alarm = true;  // it begins without an idea
  for (const DecisionRecord& record : run.decisions) {
    const double lost = record.decision.lost;
    const bool was_astray = record.astray.value_or(true);
    const bool soon = std::any_of(losses_at.begin(), losses_at.end(), [&](double at) {
      return record.last_way >= at && record.last_way < at + kSettled;
    });
    false_alarms += !alarm && lost > kLost && !was_astray && !soon ? 1 : 0;
    alarm = lost > kLost;
    const bool told_nothing = !run.moments[record.moment].online;
    if (!told_nothing && !record.astray) continue;
    Bin& bin = bins_[static_cast<std::size_t>(std::min(9.0, 10.0 * lost))];
    bin.said += lost;
    bin.was += told_nothing || was_astray ? 1.0 : 0.0;
    ++bin.scans;
  }
}

double LostFigures::calibrationError() const {
  double off = 0.0, scans = 0.0;
  for (const Bin& bin : bins_) {
    off += std::abs(bin.said - bin.was);
    scans += static_cast<double>(bin.scans);
  }
  return scans > 0.0 ? off / scans : 0.0;
}

}  // namespace place_memory::mapping
