#ifndef PLACE_MEMORY_EXPERIMENTS_FIGURES_H
#define PLACE_MEMORY_EXPERIMENTS_FIGURES_H

#include <cstdint>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/figure_file.h"

namespace place_memory::experiments {

/// Learned and recognition grids after the paper's figures 1, 2, 5 and 7 to 9. Captions tell what
/// the methods answer. Figures 8 and 9 show the first trials, from `seed` on, that go as the
/// paper's did; where none does within forty seeds, there is no such figure.
std::vector<GridFigure> gridFigures(const ShippedWorlds& worlds, const Method& nearest,
                                    const Method& climbing, const Method& ours, std::uint64_t seed);

/// The paper's figures 4 and 6: the office's map, and the hallway's as dead reckoning bends it.
std::vector<MapFigure> mapFigures(const ShippedWorlds& worlds);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_FIGURES_H
