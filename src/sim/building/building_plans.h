#ifndef PLACE_MEMORY_SIM_BUILDING_BUILDING_PLANS_H
#define PLACE_MEMORY_SIM_BUILDING_BUILDING_PLANS_H

#include "sim/building/building_draft.h"

namespace place_memory::sim {

/// Each draws the rooms, doors and gaps of one kind of building; furniture comes later.
void planCorridor(BuildingDraft& draft);
void planOpenPlan(BuildingDraft& draft);
void planLaboratory(BuildingDraft& draft);
void planHome(BuildingDraft& draft);

/// Also puts up the arena's inner walls and bins: it has no furniture.
void planArena(BuildingDraft& draft);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_BUILDING_PLANS_H
