#ifndef PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H
#define PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The number of places, and how the store is. ERROR where it is not used, for the reason
/// `store_problem`, for as long as the newest change could not be
/// written; WARN where something in it is damaged, a sentence each.
void diagnoseMemory(std::size_t places, const core::StoreHealth& health,
                    const std::string& store_path, const std::string& store_problem,
                    diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H
