#ifndef PLACE_MEMORY_EXPERIMENTS_REARRANGEMENTS_H
#define PLACE_MEMORY_EXPERIMENTS_REARRANGEMENTS_H

#include <vector>

#include "experiments/runner.h"
#include "experiments/table.h"

namespace place_memory::experiments {

/// The office, rearranged `rounds` times over, each time on top of what the last one left; after
/// each the robot comes to every place once. Some places were never learned. The memory is the
/// package's own, and its places adapt where the method has them do so.
Experiment rearrangementsExperiment(const ShippedWorlds& worlds, int rounds);

/// Of `methods` those that are compared in it, and the default once more with places that adapt.
std::vector<Method> rearrangementMethods(const std::vector<Method>& methods);

/// A row for each round and one for all of them, a column for each method: accuracies with their
/// 95 % intervals.
Table roundAccuracyTable(const std::vector<Outcome>& outcomes);

/// What adapting places took in, a row for each round and one for all.
Table foldTable(const std::vector<Outcome>& outcomes);

/// A row for each method and round, all numbers.
Table roundTable(const std::vector<Outcome>& outcomes);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_REARRANGEMENTS_H
