#include "tools/quantile_sample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace place_memory::tools {
namespace {

constexpr std::size_t kMost = 4096;

}  // namespace

void QuantileSample::add(double value) {
  if (skipped_ + 1 < stride_) {
    ++skipped_;
    return;
  }
  skipped_ = 0;
  values_.push_back(value);
  if (values_.size() < kMost) return;
  for (std::size_t i = 0; 2 * i < values_.size(); ++i) values_[i] = values_[2 * i];
  values_.resize(values_.size() / 2);
  stride_ *= 2;
}

double QuantileSample::quantile(double share, double least) const {
  std::vector<double> values;
  std::copy_if(values_.begin(), values_.end(), std::back_inserter(values),
               [least](double value) { return value >= least; });
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace place_memory::tools
