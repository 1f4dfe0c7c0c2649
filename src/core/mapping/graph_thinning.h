#ifndef PLACE_MEMORY_CORE_MAPPING_GRAPH_THINNING_H
#define PLACE_MEMORY_CORE_MAPPING_GRAPH_THINNING_H

#include <optional>
#include <vector>

#include "core/mapping/scan_graph.h"

namespace place_memory::core {

struct ThinningOptions {
  std::size_t visits = 15;  ///< scans that are kept of those about one place, the newest ones
  std::size_t untied = 3;   ///< ways without a tie that are kept between two places, likewise
  std::size_t newest = 60;  ///< scans that stay whatever they are
  double longest = 5.0;     ///< odometry over a longer way than this is not kept in one [m]
};

/// Drops scans that only say once more where known places lie, or that told nothing on a way
/// between two of them that was driven again since, so that a map is as large as its building,
/// however long the robot drives about in it. Places stay. Returns, for each node as it was, its
/// index from now on, none for those that went; nothing where there was nothing to drop.
std::optional<std::vector<std::optional<NodeIndex>>> thin(ScanGraph& graph,
                                                          const ThinningOptions& options);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_GRAPH_THINNING_H
