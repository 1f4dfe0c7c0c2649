#ifndef PLACE_MEMORY_EXPERIMENTS_STATISTICS_H
#define PLACE_MEMORY_EXPERIMENTS_STATISTICS_H

#include <array>
#include <cstddef>
#include <vector>

#include "experiments/answer.h"

namespace place_memory::experiments {

struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

/// Wilson's 95 % interval of a share; [0, 1] for no trials.
Bounds wilsonInterval(std::size_t successes, std::size_t trials);

/// Bounds within which the mean of `count` normalised errors of a pose falls in 95 % of all cases
/// where the covariances are true: chi square, three degrees of freedom each. `count` >= 1.
Bounds consistencyBounds(std::size_t count);

/// Answers whose probability falls into one tenth of [0, 1].
struct ReliabilityBin {
  std::size_t answers = 0;
  std::size_t right = 0;
  double probability_sum = 0.0;
};
constexpr std::size_t kReliabilityBins = 10;

/// What a table says of a method in an experiment. Means over no answers are NaN.
struct Summary {
  std::size_t known = 0;  ///< trials of places in the memory
  std::size_t right = 0;
  double position_error = 0.0;  ///< mean over the right ones [m]
  double within_foot = 0.0;     ///< share of the right ones that are off by no more
  std::size_t recognized = 0;   ///< known, right and RECOGNIZED
  std::size_t wrong = 0;        ///< known, not right and yet RECOGNIZED
  std::size_t strangers = 0;    ///< scans of another building
  std::size_t accepted = 0;     ///< strangers RECOGNIZED
  std::size_t unlearned = 0;    ///< scans of this building, far from every place in the memory
  std::size_t unlearned_accepted = 0;  ///< of them RECOGNIZED
  /// Of the best match being right, over known and strangers; strangers are never right.
  std::array<ReliabilityBin, kReliabilityBins> reliability;
  double calibration_error = 0.0;  ///< expected: mean over answers of their bin's |gap|
  std::size_t posed = 0;           ///< right and RECOGNIZED, with a usable covariance
  double normalised_error = 0.0;   ///< their mean; 3 where the covariance is true

  double accuracy() const { return static_cast<double>(right) / static_cast<double>(known); }
};

Summary summarize(const std::vector<Answer>& answers);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_STATISTICS_H
