#include "core/views/expected_answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace place_memory::core {

double entropyOf(const std::vector<double>& probabilities) {
  double entropy = 0.0;
  for (const double p : probabilities) {
    if (p > 0.0) entropy -= p * std::log2(p);
  }
  return entropy;
}

ExpectedAnswer expectedAnswer(const std::vector<double>& probabilities,
                              const std::vector<std::vector<double>>& likelihoods) {
  ExpectedAnswer answer;
  double left = 0.0;
  std::vector<double> after(probabilities.size());
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    double all = 0.0;
    for (std::size_t k = 0; k < probabilities.size(); ++k) {
      after[k] = probabilities[k] * likelihoods[i][k];
      all += after[k];
    }
    for (double& p : after) p /= all;
    left += probabilities[i] * entropyOf(after);
    answer.probability += probabilities[i] * *std::max_element(after.begin(), after.end());
  }
  // What is seen may speak for a wrong candidate; on an average it does not unteach.
  answer.information = std::max(entropyOf(probabilities) - left, 0.0);
  return answer;
}

}  // namespace place_memory::core
