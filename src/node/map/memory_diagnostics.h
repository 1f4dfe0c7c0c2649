#ifndef PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H
#define PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// ERROR with what is wrong with the store where `store_problem` is not empty, otherwise OK with
/// the number of places; the path of the store.
void diagnoseMemory(const core::PlaceMemory& memory, const std::string& store_path,
                    const std::string& store_problem,
                    diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MEMORY_DIAGNOSTICS_H
