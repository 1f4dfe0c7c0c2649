#include "sim/building/building_generator.h"

#include <string>

#include "sim/building/building_draft.h"
#include "sim/building/building_plans.h"
#include "sim/building/furnisher.h"
#include "sim/building/place_layout.h"
#include "sim/world/random.h"
#include "sim/world/world_transform.h"

namespace place_memory::sim {

namespace {

constexpr std::size_t kFewestPlaces = 4;

void drawPlan(BuildingKind kind, BuildingDraft& draft) {
  switch (kind) {
    case BuildingKind::kCorridor:
      planCorridor(draft);
      break;
    case BuildingKind::kOpenPlan:
      planOpenPlan(draft);
      break;
    case BuildingKind::kLaboratory:
      planLaboratory(draft);
      break;
    case BuildingKind::kHome:
      planHome(draft);
      break;
    case BuildingKind::kArena:
      planArena(draft);
      break;
  }
}

const char* nameOf(BuildingKind kind) {
  const char* names[] = {"corridor", "open_plan", "laboratory", "home", "arena"};
  return names[static_cast<std::size_t>(kind)];
}

World drawBuilding(BuildingKind kind, Rng& rng) {
  BuildingDraft draft(randomStyle(rng), rng);
  drawPlan(kind, draft);
  for (const Room& room : draft.rooms()) furnish(draft, room);
  PlaceSpacing spacing{uniform(rng, 1.4, 1.7), placeClearance(kind), 60};
  if (kind == BuildingKind::kArena) spacing = {uniform(rng, 0.45, 0.9), placeClearance(kind), 9};
  World world = draft.finish();
  layPlaces(world, draft.rooms(), spacing, rng);
  // Half of all buildings lie along the compass, as evidence grids do.
  const double turn = chance(rng, 0.5) ? 0.5 * core::kPi * uniformInt(rng, 0, 3)
                                       : uniform(rng, -core::kPi, core::kPi);
  transformWorld(world, {uniform(rng, -5.0, 5.0), uniform(rng, -5.0, 5.0), turn});
  return world;
}

}  // namespace

double placeClearance(BuildingKind kind) { return kind == BuildingKind::kArena ? 0.15 : 0.3; }

World generateBuilding(BuildingKind kind, std::uint64_t seed) {
  Rng rng(seed);
  for (;;) {
    World world = drawBuilding(kind, rng);
    if (world.places.size() < kFewestPlaces) continue;
    world.name = std::string(nameOf(kind)) + "_" + std::to_string(seed);
    return world;
  }
}

World generateBuilding(std::uint64_t seed) {
  // A stream of its own, so that the kind says nothing about the rest of the building.
  Rng rng(seed ^ 0x9e3779b97f4a7c15U);
  return generateBuilding(static_cast<BuildingKind>(uniformInt(rng, 0, kBuildingKinds - 1)), seed);
}

}  // namespace place_memory::sim
