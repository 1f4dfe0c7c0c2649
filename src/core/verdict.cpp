#include "place_memory/core/verdict.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

double probabilityOf(const Calibration& calibration, const Agreement& agreement, double lead) {
  double log_odds = calibration.bias + calibration.margin * std::log1p(calibration.scale * lead);
  for (std::size_t r = 0; r < agreement.size(); ++r) {
    for (std::size_t l = 0; l < agreement[r].size(); ++l) {
      log_odds += agreement[r][l] * calibration.shares[r][l];
    }
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

/// Splits `rest` among all matches but the first.
void shareAmongOthers(double rest, double scale, std::vector<PlaceMatch>& matches) {
  double all = 0.0;
  const auto weight = [&](const PlaceMatch& match) {
    return std::exp(scale * (match.score - matches[1].score));
  };
  for (std::size_t i = 1; i < matches.size(); ++i) all += weight(matches[i]);
  for (std::size_t i = 1; i < matches.size(); ++i) {
    matches[i].probability = rest * weight(matches[i]) / all;
  }
}

}  // namespace

Agreement agreementOf(const PairCounts& at, const PairCounts& own) {
  constexpr std::array<std::size_t, 2> kSensed{static_cast<std::size_t>(CellClass::kEmpty),
                                               static_cast<std::size_t>(CellClass::kOccupied)};
  Agreement agreement{};
  for (std::size_t r = 0; r < kSensed.size(); ++r) {
    const int cells = own[kSensed[r]][kSensed[r]];
    if (cells == 0) continue;
    for (std::size_t l = 0; l < kSensed.size(); ++l) {
      agreement[r][l] = static_cast<double>(at[kSensed[r]][kSensed[l]]) / cells;
    }
  }
  return agreement;
}

void judge(const Agreement& agreement, double lead, const Calibration& calibration,
           double confidence, Recognition& recognition) {
  std::vector<PlaceMatch>& matches = recognition.matches;
  recognition.verdict = Verdict::kUnknown;
  if (matches.empty()) return;
  const double best = matches.front().score;
  const double probability = probabilityOf(calibration, agreement, std::max(lead, 0.0));
  matches.front().probability = probability;
  if (matches.size() > 1) {
    const double rest = std::min(calibration.others * (1.0 - probability), probability);
    shareAmongOthers(rest, calibration.scale, matches);
  }
  if (probability >= confidence) {
    recognition.verdict = Verdict::kRecognized;
  } else if (probabilityOf(calibration, agreement, std::max(best, 0.0)) >= confidence) {
    recognition.verdict = Verdict::kAmbiguous;
  }
}

}  // namespace place_memory::core
