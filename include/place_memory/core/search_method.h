#ifndef PLACE_MEMORY_CORE_SEARCH_METHOD_H
#define PLACE_MEMORY_CORE_SEARCH_METHOD_H

namespace place_memory::core {

/// How the alignment of each place is sought.
enum class SearchMethod {
  kNearestNeighbour,  ///< no translation, no rotation: the paper's baseline (paper 5)
  kHillClimbing,      ///< multiresolution, one climb from the compass heading (paper 4)
  kRestarts,          ///< hill climbing from several headings and positions (paper 4, last lines)
  kExhaustive,        ///< every transform in the window: the oracle
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SEARCH_METHOD_H
