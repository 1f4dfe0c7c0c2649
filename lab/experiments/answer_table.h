#ifndef PLACE_MEMORY_EXPERIMENTS_ANSWER_TABLE_H
#define PLACE_MEMORY_EXPERIMENTS_ANSWER_TABLE_H

#include <vector>

#include "experiments/runner.h"
#include "experiments/table.h"

namespace place_memory::experiments {

/// Every answer, a row each.
Table answerTable(const std::vector<Outcome>& outcomes);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_ANSWER_TABLE_H
