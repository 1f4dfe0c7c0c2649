#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_GOAL_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_GOAL_H

#include <place_memory/RejectCount.h>
#include <place_memory/ScanPlaceGoal.h>

#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/input/reject.h"

namespace place_memory::node {

/// A goal of ~scan with the parameters in place of what it leaves open.
struct ScanRequest {
  int headings = 0;   ///< 0: to be planned by the sensors there are
  double step = 0.0;  ///< [rad]; 0: to be planned too
  config::Turn turn = config::Turn::kListen;
  double timeout = 0.0;           ///< [s]
  bool longer_if_needed = false;  ///< a planned turn may take longer
};

/// Nothing where a field is out of range; `problem` then says which.
std::optional<ScanRequest> readGoal(const ScanPlaceGoal& goal, const config::ScanOptions& defaults,
                                    std::string& problem);

/// The counts that are not 0.
std::vector<RejectCount> toMessage(const RejectCounts& rejected);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_GOAL_H
