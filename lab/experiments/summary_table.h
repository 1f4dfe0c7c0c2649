#ifndef PLACE_MEMORY_EXPERIMENTS_SUMMARY_TABLE_H
#define PLACE_MEMORY_EXPERIMENTS_SUMMARY_TABLE_H

#include <string>
#include <vector>

#include "experiments/runner.h"
#include "experiments/table.h"

namespace place_memory::experiments {

/// A row for each experiment, a column for each method and one for the paper's figure beside each
/// method that the paper has: accuracies with their 95 % intervals.
Table accuracyTable(const std::vector<Outcome>& outcomes);

/// What one method answers, a row for each experiment and one for all of them together: accuracy,
/// pose, verdicts, strangers, calibration, consistency of the covariance.
Table verdictTable(const std::vector<Outcome>& outcomes, const std::string& method);

/// How one method's verdicts spread over all experiments together: a row for each kind of scan.
Table verdictShareTable(const std::vector<Outcome>& outcomes, const std::string& method);

/// The same as verdictTable() for every method over all experiments together.
Table methodTable(const std::vector<Outcome>& outcomes);

/// A row for each outcome, all numbers.
Table summaryTable(const std::vector<Outcome>& outcomes);

/// A row for each method and tenth of the probability, over all experiments.
Table reliabilityTable(const std::vector<Outcome>& outcomes);

/// The same for people, of one method; tenths in which no answer fell are left out.
Table calibrationTable(const std::vector<Outcome>& outcomes, const std::string& method);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_SUMMARY_TABLE_H
