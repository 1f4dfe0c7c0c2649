#ifndef PLACE_MEMORY_CORE_RECOGNIZE_PEAK_SHARPNESS_H
#define PLACE_MEMORY_CORE_RECOGNIZE_PEAK_SHARPNESS_H

#include "core/match/alignment_search.h"

namespace place_memory::core {

/// How the search's score changes beside an alignment: it falls all around where the grids fit, and
/// hardly along a hallway or where they fit by chance.
struct PeakSharpness {
  double shift = 0.0;     ///< by a shift of two cells, the mean of four
  double rotation = 0.0;  ///< by a rotation of two heading steps, the mean of those in the window
};

/// Of the learned grid with the recognition grid at the alignment, which lies in the window.
PeakSharpness peakSharpness(const QueryPlanes& query, const CellPlanes& learned,
                            const LatticeMetric& metric, const SearchWindow& window,
                            const Alignment& at);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_PEAK_SHARPNESS_H
