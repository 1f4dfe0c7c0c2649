#ifndef PLACE_MEMORY_TOOLS_QUANTILE_SAMPLE_H
#define PLACE_MEMORY_TOOLS_QUANTILE_SAMPLE_H

#include <cstddef>
#include <limits>
#include <vector>

namespace place_memory::tools {

/// Quantiles of any number of values in bounded memory: once there are many, of evenly spread
/// ones.
class QuantileSample {
 public:
  void add(double value);
  bool empty() const { return values_.empty(); }
  /// The least value that this share of the values, in (0, 1], does not exceed; of those from
  /// `least` on, of which there must be one.
  double quantile(double share, double least = -std::numeric_limits<double>::infinity()) const;

 private:
  std::vector<double> values_;
  std::size_t stride_ = 1;  // one of so many is kept
  std::size_t skipped_ = 0;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_QUANTILE_SAMPLE_H
