#ifndef PLACE_MEMORY_SIM_BUILDING_FURNISHER_H
#define PLACE_MEMORY_SIM_BUILDING_FURNISHER_H

#include "sim/building/building_draft.h"

namespace place_memory::sim {

/// Fills the room with what its use suggests, clear of the doorways and of what already stands
/// there.
void furnish(BuildingDraft& draft, const Room& room);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_FURNISHER_H
