#ifndef PLACE_MEMORY_CORE_VIEWS_EXPECTED_ANSWER_H
#define PLACE_MEMORY_CORE_VIEWS_EXPECTED_ANSWER_H

#include <vector>

namespace place_memory::core {

/// What is known once one of several candidates was looked at, on an average over which of them is
/// the true one.
struct ExpectedAnswer {
  double information = 0.0;  ///< by which the entropy of the candidates falls [bit], >= 0
  double probability = 0.0;  ///< of the likeliest candidate then
};

/// Of candidates, by their probabilities [bit].
double entropyOf(const std::vector<double>& probabilities);

/// `probabilities` sum up to 1. `likelihoods[i][k]`: of what is seen where candidate i is the true
/// one, if k were, > 0; those of one i count relative to each other.
ExpectedAnswer expectedAnswer(const std::vector<double>& probabilities,
                              const std::vector<std::vector<double>>& likelihoods);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VIEWS_EXPECTED_ANSWER_H
