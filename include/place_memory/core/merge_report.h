#ifndef PLACE_MEMORY_CORE_MERGE_REPORT_H
#define PLACE_MEMORY_CORE_MERGE_REPORT_H

#include <cstddef>
#include <string>
#include <vector>

namespace place_memory::core {

/// What came of taking in the places of another store.
struct MergeReport {
  /// A label that a place of the map had already, and what the new place is called instead.
  struct Collision {
    std::string label;
    std::string new_label;
  };

  std::size_t added = 0;   ///< places
  std::size_t known = 0;   ///< places that were in the map already, by identity or recognition
  std::size_t joined = 0;  ///< sessions of the other store that lie in a frame of the map now
  std::size_t apart = 0;   ///< sessions whose frame is not known: they are sessions of their own
  std::vector<Collision> collisions;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MERGE_REPORT_H
