#include "tools/quantile_sample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

double QuantileSample::quantile(double share) const {
  std::vector<double> values = values_;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto at = values.begin() + std::max<std::ptrdiff_t>(rank, 1) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace place_memory::tools
