#include "place_memory/core/verdict.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace place_memory::core {
namespace {

constexpr std::size_t kLead = 11, kProminence = 12, kUncontested = 13;
/// A lead and a prominence that leave no doubt, in units of the scale.
constexpr double kClear = 10.0;

double probabilityOf(const Calibration& calibration, const Support& support) {
  double log_odds = 0.0;
  for (std::size_t i = 0; i < support.size(); ++i) {
    log_odds += calibration.coefficients[i] * support[i];
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

/// Splits `rest` among all matches but the first.
void shareAmongOthers(double rest, double scale, std::vector<PlaceMatch>& matches) {
  double all = 0.0;
  double best = matches[1].score;
  for (std::size_t i = 2; i < matches.size(); ++i) best = std::max(best, matches[i].score);
  const auto weight = [&](const PlaceMatch& match) {
    return std::exp(scale * (match.score - best));
  };
  for (std::size_t i = 1; i < matches.size(); ++i) all += weight(matches[i]);
  for (std::size_t i = 1; i < matches.size(); ++i) {
    matches[i].probability = rest * weight(matches[i]) / all;
  }
}

}  // namespace

Support supportOf(const PairCounts& at, const CloseCounts& closely, const PairCounts& own,
                  const Consensus& consensus, std::size_t places, double scale) {
  constexpr auto kEmpty = static_cast<std::size_t>(CellClass::kEmpty);
  constexpr auto kOccupied = static_cast<std::size_t>(CellClass::kOccupied);
  const auto ratio = [](int cells, int of) {
    return of == 0 ? 0.0 : static_cast<double>(cells) / of;
  };
  const auto share = [&](int cells, std::size_t of) { return ratio(cells, own[of][of]); };
  const auto learned = [&](std::size_t of) { return at[0][of] + at[1][of] + at[2][of]; };
  return {1.0,
          share(at[kEmpty][kEmpty], kEmpty),
          share(at[kEmpty][kOccupied], kEmpty),
          share(at[kOccupied][kEmpty], kOccupied),
          share(at[kOccupied][kOccupied], kOccupied),
          share(closely.of(NearCells::kOccupiedWithinOne), kOccupied),
          share(closely.of(NearCells::kOccupiedWithinTwo), kOccupied),
          share(closely.of(NearCells::kEmptyByOccupied), kEmpty),
          ratio(at[kEmpty][kOccupied], learned(kOccupied)),
          ratio(at[kOccupied][kOccupied], learned(kOccupied)),
          ratio(at[kOccupied][kEmpty], learned(kEmpty)),
          std::log1p(scale * std::max(consensus.lead, 0.0)),
          scale * consensus.prominence,
          scale * consensus.uncontested,
          1.0 / static_cast<double>(std::max<std::size_t>(places, 1))};
}

void judge(const Support& support, const Calibration& calibration, double confidence,
           Recognition& recognition) {
  std::vector<PlaceMatch>& matches = recognition.matches;
  recognition.verdict = Verdict::kUnknown;
  if (matches.empty()) return;
  const double probability = probabilityOf(calibration, support);
  matches.front().probability = probability;
  if (matches.size() > 1) {
    const double rest = std::min(calibration.others * (1.0 - probability), probability);
    shareAmongOthers(rest, calibration.scale, matches);
  }
  const bool contested = support[kUncontested] == 0.0;
  Support clear = support;
  clear[kLead] = std::max(clear[kLead], std::log1p(kClear));
  clear[kProminence] = std::max(clear[kProminence], kClear);
  if (probability >= confidence) {
    recognition.verdict = Verdict::kRecognized;
  } else if (contested && probabilityOf(calibration, clear) >= confidence) {
    recognition.verdict = Verdict::kAmbiguous;
  }
}

}  // namespace place_memory::core
