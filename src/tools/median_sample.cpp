#include "tools/median_sample.h"

#include <algorithm>

namespace place_memory::tools {
namespace {

constexpr std::size_t kMost = 4096;

}  // namespace

void MedianSample::add(double value) {
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

double MedianSample::median() const {
  std::vector<double> values = values_;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace place_memory::tools
