#include "experiments/statistics.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

#include "experiments/recipes.h"

namespace place_memory::experiments {
namespace {

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  double value() const {
    return count_ > 0 ? sum_ / static_cast<double>(count_)
                      : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

double calibrationError(const std::array<ReliabilityBin, kReliabilityBins>& bins) {
  double gaps = 0.0;
  std::size_t answers = 0;
  for (const ReliabilityBin& bin : bins) {
    gaps += std::abs(bin.probability_sum - static_cast<double>(bin.right));
    answers += bin.answers;
  }
  return answers > 0 ? gaps / static_cast<double>(answers)
                     : std::numeric_limits<double>::quiet_NaN();
}

void count(const Answer& answer, Summary& summary) {
  const bool recognized = answer.verdict == core::Verdict::kRecognized;
  if (!answer.known) {
    ++(answer.stranger ? summary.strangers : summary.unlearned);
    if (recognized) ++(answer.stranger ? summary.accepted : summary.unlearned_accepted);
    return;
  }
  ++summary.known;
  if (answer.right) ++summary.right;
  if (recognized) ++(answer.right ? summary.recognized : summary.wrong);
}

}  // namespace

Bounds wilsonInterval(std::size_t successes, std::size_t trials) {
  if (trials == 0) return {0.0, 1.0};
  constexpr double kZ = 1.959964;
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double scale = 1.0 / (1.0 + kZ * kZ / n);
  const double centre = scale * (share + kZ * kZ / (2.0 * n));
  const double half = scale * kZ * std::sqrt(share * (1.0 - share) / n + kZ * kZ / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Bounds consistencyBounds(std::size_t count) {
  const auto n = static_cast<double>(count);
  const boost::math::chi_squared distribution(3.0 * n);
  return {boost::math::quantile(distribution, 0.025) / n,
          boost::math::quantile(distribution, 0.975) / n};
}

Summary summarize(const std::vector<Answer>& answers) {
  Summary summary;
  Mean position;
  Mean within;
  Mean normalised;
  for (const Answer& answer : answers) {
    count(answer, summary);
    // Known scans once more: they would outweigh the others.
    if (!answer.known && !answer.stranger) continue;
    const auto bin = std::min(static_cast<std::size_t>(answer.probability * kReliabilityBins),
                              kReliabilityBins - 1);
    ++summary.reliability[bin].answers;
    summary.reliability[bin].probability_sum += answer.probability;
    if (!answer.right) continue;
    ++summary.reliability[bin].right;
    position.add(answer.position_error);
    within.add(answer.position_error <= kOneFoot ? 1.0 : 0.0);
    if (answer.verdict == core::Verdict::kRecognized && std::isfinite(answer.normalised_error)) {
      ++summary.posed;
      normalised.add(answer.normalised_error);
    }
  }
  summary.position_error = position.value();
  summary.within_foot = within.value();
  summary.normalised_error = normalised.value();
  summary.calibration_error = calibrationError(summary.reliability);
  return summary;
}

}  // namespace place_memory::experiments
